#include "goals_nearby.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "fourwis_navigation/map/body_overlap.h"

namespace fourwis
{
namespace
{

/// Steps from the goal to the farthest pose, at most: some 2000 poses.
constexpr double kMostSteps = 25.0;
/// Of a radius that is a whole number of steps but for the last bits.
constexpr double kRounding = 1e-6;

/// Beyond the farthest corner of the map there is no goal.
double farthest_corner(const OccupancyGrid& grid, const Pose& pose)
{
  const double width = grid.width * grid.resolution, height = grid.height * grid.resolution;
  return std::hypot(std::max(std::abs(pose.x), std::abs(width - pose.x)),
                    std::max(std::abs(pose.y), std::abs(height - pose.y)));
}

}  // namespace

std::vector<Point2> lattice_around(double radius, double step)
{
  if (radius <= 0.0) return {};
  const double side = std::max(std::min(step, radius), radius / kMostSteps);
  const double steps = radius / side + kRounding;
  const int most = static_cast<int>(steps);
  struct Node
  {
    int square;  ///< of its distance, in steps
    double direction;
    Point2 offset;
  };
  std::vector<Node> nodes;
  for (int j = -most; j <= most; ++j)
    for (int i = -most; i <= most; ++i)
    {
      const int square = i * i + j * j;
      if (square > 0 && square <= steps * steps) nodes.push_back({square, std::atan2(j, i), {i * side, j * side}});
    }
  std::sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) {
    return std::tie(a.square, a.direction) < std::tie(b.square, b.direction);
  });
  std::vector<Point2> offsets;
  offsets.reserve(nodes.size());
  for (const Node& node : nodes) offsets.push_back(node.offset);
  return offsets;
}

std::vector<Pose> free_goals_nearby(const World& world, const PlannerOptions& options, const PlanRequest& request)
{
  const Pose& goal = request.goal;
  const ConvexPolygon body = body_of(world.robot);
  const double radius = std::min(request.goal_tolerance, farthest_corner(world.grid, goal));
  const double step = std::max(world.grid.resolution, options.search.cell_size(world.robot));
  std::vector<Pose> goals;
  for (const Point2& offset : lattice_around(radius, step))
  {
    const Pose pose = {goal.x + offset.x, goal.y + offset.y, goal.theta};
    if (is_clear(world.obstacles, body, placed(pose))) goals.push_back(pose);
  }
  return goals;
}

}  // namespace fourwis
