#include "fourwis_navigation/corridor/polytope_corridor.h"

#include <algorithm>
#include <cmath>

#include "chord_region.h"
#include "fourwis_navigation/model/option_check.h"
#include "no_corridor.h"
#include "polygon.h"

namespace fourwis
{
namespace
{

/// What is wrong with the arguments; empty if they are valid.
std::string complaint(const std::vector<Pose>& knots, const std::vector<double>& shrink)
{
  if (std::string wrong = complaint(knots); !wrong.empty()) return wrong;
  if (!shrink.empty() && shrink.size() != knots.size() - 1)
    return sentence("shrink has %zu values for %zu intervals", shrink.size(), knots.size() - 1);
  for (std::size_t i = 0; i < shrink.size(); ++i)
    if (!(shrink[i] >= 0.0) || !std::isfinite(shrink[i]))
      return sentence("shrink of interval %zu is %g m, expected a finite number, 0 or more", i, shrink[i]);
  return {};
}

std::string collision_sentence(std::size_t interval, const Point2& centre, const Pose& from, const Pose& to)
{
  return sentence(
      "between knots %zu and %zu the centre of the disc at (%.6g, %.6g) m on the body meets an obstacle or the "
      "map's border: it goes from (%.6g, %.6g) to (%.6g, %.6g)",
      interval, interval + 1, centre.x, centre.y, from.x, from.y, to.x, to.y);
}

}  // namespace

void check(const PolytopeOptions& options)
{
  check_ranges(options);
}

PolytopeCorridor polytope_corridor(const ObstacleRectangles& obstacles, const DiscCover& discs,
                                   const PolytopeOptions& options, const std::vector<Pose>& knots,
                                   const std::vector<double>& shrink)
{
  check(options);
  const std::string wrong = complaint(knots, shrink);
  if (!wrong.empty()) return no_corridor<Corridor>(CorridorStatus::invalid_input, wrong);

  PolytopeCorridor corridor;
  for (const Point2& centre : discs.centres) corridor.regions.push_back({centre, {}});
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
  {
    const double keep = discs.radius + (shrink.empty() ? 0.0 : shrink[i]);
    double deficit = 0.0;
    for (DiscRegions& disc : corridor.regions)
    {
      const Pose centre{disc.centre.x, disc.centre.y, 0.0};
      const Pose from = compose(knots[i], centre), to = compose(knots[i + 1], centre);
      const Chord chord(obstacles.to_grid(from.x, from.y), obstacles.to_grid(to.x, to.y));
      ChordRegion region = chord_region(obstacles, chord, keep, options);
      if (region.planes.empty())
        return no_corridor<Corridor>(CorridorStatus::in_collision, collision_sentence(i, disc.centre, from, to));
      for (HalfPlane& plane : region.planes) plane = obstacles.to_map(plane);
      disc.regions.push_back(std::move(region.planes));
      deficit = std::max(deficit, region.deficit);
    }
    corridor.deficit.push_back(deficit);
  }
  corridor.status = CorridorStatus::succeeded;
  return corridor;
}

std::vector<Point2> corners(const Polytope& polytope, const Point2& centre, double reach)
{
  Polygon polygon(centre, reach);
  for (std::size_t i = 0; i < polytope.size(); ++i) polygon.cut(polytope[i], static_cast<int>(i));
  return polygon.corners();
}

}  // namespace fourwis
