#include "endpoints.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fourwis_navigation/map/body_overlap.h"
#include "fourwis_navigation/model/sentence.h"
#include "fourwis_navigation/vehicle/base_link.h"

namespace fourwis
{
namespace
{

/// Headings at which a free pose is looked for.
constexpr int kHeadings = 32;
/// How far away it is looked for, in sizes of the robot, and the steps to there.
constexpr double kFarthest = 10.0;
constexpr int kRings = 100;

bool is_known(std::int8_t cell)
{
  return cell >= 0 && cell <= 100;
}

/// How far base_link has to be moved, and by what angle turned, to be where the body is clear.
struct Move
{
  double distance, turn;  ///< [m], [rad]
};

/// The shortest, nothing where the body is clear nowhere near.
std::optional<Move> nearest_free(const World& world, const Pose& asked_centre)
{
  const ConvexPolygon body = body_of(world.robot);
  const BaseLink base_link(world.robot);
  const OccupancyGrid& grid = world.grid;
  const Pose asked = base_link.from_centre(asked_centre);
  const Pose pose = {std::clamp(asked.x, 0.0, grid.width * grid.resolution),
                     std::clamp(asked.y, 0.0, grid.height * grid.resolution), asked.theta};
  const double step = kFarthest * world.robot.size() / kRings;
  for (int ring = 0; ring <= kRings; ++ring)
  {
    const double radius = ring * step;
    const int count = std::max(1, static_cast<int>(std::ceil(2.0 * M_PI * ring)));
    for (int i = 0; i < count; ++i)
      for (int k = 0; k < kHeadings; ++k)
      {
        const double direction = 2.0 * M_PI * i / count, turn = 2.0 * M_PI * k / kHeadings;
        const Pose there = {pose.x + radius * std::cos(direction), pose.y + radius * std::sin(direction),
                            pose.theta + turn};
        if (is_clear(world.obstacles, body, placed(base_link.to_centre(there))))
          return Move{distance(there, asked), wrap_angle(turn)};
      }
  }
  return std::nullopt;
}

std::string nearest_sentence(const World& world, const Pose& pose)
{
  if (const std::optional<Move> move = nearest_free(world, pose))
    return sentence("the nearest free pose is %.2f m away", move->distance) +
           (move->turn == 0.0 ? "" : sentence(", turned by %.0f deg", move->turn * 180.0 / M_PI));
  return sentence("a body of %.2f x %.2f m fits nowhere within %.1f m", world.robot.body_length(),
                  world.robot.body_width(), kFarthest * world.robot.size());
}

}  // namespace

Endpoint endpoint(const World& world, const PlannerOptions& options, const Pose& pose)
{
  const ConvexPolygon body = body_of(world.robot);
  Endpoint result;
  result.clearance = body_clearance(world.obstacles, body, pose, world.robot.safety_margin);
  if (result.clearance >= 0.0) return result;
  result.off_map = !lies_in(world.obstacles, body, pose);
  result.unseen = true;
  for (const CellIndex& cell : overlapped_cells(world.obstacles, body, pose))
  {
    const std::int8_t value = world.grid.at(cell.column, cell.row);
    if (is_known(value) && options.obstacles.is_obstacle(value)) result.unseen = false;
  }
  return result;
}

std::string collision_sentence(const World& world, const Endpoint& endpoint, const char* place, const Pose& asked,
                               const Pose& pose)
{
  const std::string where = sentence("the %s (%.3f, %.3f, %.3f) ", place, asked.x, asked.y, asked.theta);
  const OccupancyGrid& grid = world.grid;
  if (endpoint.off_map)
    return where +
           sentence("is off the map, which is %.2f x %.2f m large; ", grid.width * grid.resolution,
                    grid.height * grid.resolution) +
           nearest_sentence(world, pose);
  if (endpoint.unseen) return where + "lies on cells that no sensor has seen; " + nearest_sentence(world, pose);
  if (!std::isfinite(endpoint.clearance))
    return where + "is in collision: it lies in an obstacle; " + nearest_sentence(world, pose);
  return where + sentence("is in collision: the body overlaps an obstacle by %.3f m; ", -endpoint.clearance) +
         nearest_sentence(world, pose);
}

bool stands_on_unseen_ground(const World& world, const Pose& pose)
{
  const std::vector<CellIndex> cells =
      overlapped_cells(world.obstacles, grown(body_of(world.robot), world.robot.safety_margin), pose);
  return std::any_of(cells.begin(), cells.end(), [&](const CellIndex& cell) {
    return !is_known(world.grid.at(cell.column, cell.row)) &&
           world.obstacles.next_obstacle(cell.column, cell.row) == cell.column;
  });
}

OccupancyGrid with_free_ground(OccupancyGrid grid, const World& world, const Pose& pose)
{
  const ConvexPolygon ground = grown(body_of(world.robot), world.robot.safety_margin);
  for (const CellIndex& cell : overlapped_cells(world.obstacles, ground, pose))
  {
    std::int8_t& value = grid.data[static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(grid.width) +
                                   static_cast<std::size_t>(cell.column)];
    if (!is_known(value)) value = 0;
  }
  return grid;
}

}  // namespace fourwis
