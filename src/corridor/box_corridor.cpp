#include "fourwis_navigation/corridor/box_corridor.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "box_growth.h"
#include "closest_points.h"
#include "fourwis_navigation/model/option_check.h"
#include "no_corridor.h"

namespace fourwis
{
namespace
{

/// Waypoints this near to an obstacle lie in it [m].
constexpr double kTouches = 1e-6;

/// Distance from a waypoint to the nearest obstacle or `most`, the less of the two [m].
double clearance(const ObstacleRectangles& obstacles, const Pose& waypoint, double most)
{
  const Point2 p = obstacles.to_grid(waypoint.x, waypoint.y);
  if (!obstacles.contains(p)) return 0.0;
  obstacles.any_of({p.x - most, p.y - most, p.x + most, p.y + most}, [&](const Box& obstacle) {
    const Point2 q = nearest(obstacle, p);
    most = std::min(most, std::hypot(q.x - p.x, q.y - p.y));
    return false;
  });
  return most;
}

/// Places of one disc's centre at the knots.
std::vector<Pose> places(const std::vector<Pose>& knots, double offset)
{
  std::vector<Pose> centres;
  centres.reserve(knots.size());
  for (const Pose& knot : knots) centres.push_back(compose(knot, {offset, 0.0, 0.0}));
  return centres;
}

/// Makes one box for each place, and raises `deficit` if the place is too close. Returns a sentence if there is no box,
/// else an empty one.
std::string append_boxes(const ObstacleRectangles& obstacles, const std::vector<Pose>& places, const char* disc,
                         double radius, const BoxOptions& options, std::vector<Box>& boxes,
                         std::vector<double>& deficit)
{
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double keep = clearance(obstacles, places[i], radius);
    if (keep < kTouches)
      return sentence("at knot %zu the centre of the %s disc, (%.6g, %.6g), lies in an obstacle or outside the map", i,
                      disc, places[i].x, places[i].y);
    const std::size_t from = std::min(i, places.size() - 2);
    const double vx = places[from + 1].x - places[from].x, vy = places[from + 1].y - places[from].y;
    boxes.push_back(grow_box(obstacles, places[i], {vx, vy}, keep, options));
    deficit[i] = std::max(deficit[i], radius - keep);
  }
  return {};
}

}  // namespace

void check(const BoxOptions& options)
{
  check_ranges(options);
  if (options.coarse_step < options.fine_step)
    reject_option("coarse_step", to_text(options.coarse_step), "at least fine_step, " + to_text(options.fine_step));
  if (options.max_expansion < options.coarse_step)
    reject_option("max_expansion", to_text(options.max_expansion),
                  "at least coarse_step, " + to_text(options.coarse_step));
}

BoxCorridorResult box_corridor(const ObstacleRectangles& obstacles, const TwoDiscs& discs, const BoxOptions& options,
                               const std::vector<Pose>& knots)
{
  check(options);
  std::string wrong = complaint(knots);
  if (!wrong.empty()) return no_corridor<BoxCorridor>(CorridorStatus::invalid_input, wrong);

  BoxCorridorResult corridor;
  corridor.deficit.assign(knots.size(), 0.0);
  wrong = append_boxes(obstacles, places(knots, discs.offset), "front", discs.radius, options, corridor.regions.front,
                       corridor.deficit);
  if (wrong.empty())
    wrong = append_boxes(obstacles, places(knots, -discs.offset), "rear", discs.radius, options, corridor.regions.rear,
                         corridor.deficit);
  if (!wrong.empty()) return no_corridor<BoxCorridor>(CorridorStatus::in_collision, wrong);
  corridor.status = CorridorStatus::succeeded;
  return corridor;
}

}  // namespace fourwis
