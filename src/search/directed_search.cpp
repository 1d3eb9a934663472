#include "directed_search.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace fourwis
{
namespace
{

/// Beyond the first way to the start, distances to the goal are known this much further, in sizes of the robot.
constexpr double kFieldSlack = 4.0;
/// Between the points of the lattice of poses, in sizes of the robot at most, and how many points there may be.
constexpr double kLatticeSpacing = 0.025;
constexpr double kMostLatticePoints = 1.5e6;

}  // namespace

DirectedSearch::DirectedSearch(const SearchProblem& problem)
  : problem_(problem),
    distance_(problem_, kFieldSlack * problem_.checker.robot().size())
{}

/// A part of a cell of the map where that is larger, so that the points lie in the middle of gaps, too.
double DirectedSearch::lattice_spacing() const
{
  const ObstacleMap& map = problem_.checker.map();
  const double area = map.width() * map.resolution() * map.height() * map.resolution();
  const double wanted =
      std::max(kLatticeSpacing * problem_.checker.robot().size(), std::sqrt(area / kMostLatticePoints));
  return wanted < map.resolution() ? map.resolution() / std::ceil(map.resolution() / wanted - 1e-9) : wanted;
}

const HolonomicDistance& DirectedSearch::holonomic_distance() const
{
  std::call_once(once_, [&] {
    holonomic_distance_ =
        std::make_unique<HolonomicDistance>(problem_, lattice_spacing(), kFieldSlack * problem_.checker.robot().size());
  });
  return *holonomic_distance_;
}

SearchResult DirectedSearch::quick(const SearchOptions& options, const ModeSet& modes,
                                   std::vector<Pose>* expanded) const
{
  const Guide guide = {[&](const Pose& pose) { return distance_(pose.x, pose.y); }};
  return hybrid_astar(problem_, options, modes, guide, expanded);
}

SearchResult DirectedSearch::guided(const SearchOptions& options, const ModeSet& modes,
                                    std::vector<Pose>* expanded) const
{
  const HolonomicDistance& field = holonomic_distance();
  const Guide guide = {std::cref(field), [&](const Pose& pose, std::vector<Pose>& way) { field.way_ahead(pose, way); },
                       kBin};
  return hybrid_astar(problem_, options, modes, guide, expanded);
}

}  // namespace fourwis
