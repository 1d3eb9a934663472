#include "place.h"

#include "../support/grids.h"
#include "driven_body.h"

namespace fourwis::nightly
{
namespace
{

constexpr double kEndGap = 0.001, kEndHeadingGap = 0.001;  ///< of a trajectory's ends [m], [rad]

OccupancyGrid at_origin(OccupancyGrid grid)
{
  grid.origin = {};
  return grid;
}

/// A wall of two cells across the grid, with one gap.
void add_wall(OccupancyGrid& grid, Random& random)
{
  const bool upright = random.chance(0.5);
  const int across = upright ? grid.width : grid.height, along = upright ? grid.height : grid.width;
  const int at = random.whole(0, across - 2), gap = random.whole(0, along - 1);
  const int gap_end = gap + static_cast<int>(random.between(0.5, 1.4) / grid.resolution);
  for (const auto& [first, end] : {std::pair(0, gap), std::pair(gap_end, along)})
    if (upright)
      occupy_block(grid, at, first, 2, end - first);
    else
      occupy_block(grid, first, at, end - first, 2);
}

bool are_same(const Pose& a, const Pose& b)
{
  return distance(a, b) <= kEndGap && heading_gap(a.theta, b.theta) <= kEndHeadingGap;
}

std::string fault_in_trajectory(const Place& place, const PlanRequest& request, const Trajectory& trajectory)
{
  if (trajectory.empty()) return "there is no trajectory";
  if (!are_same(trajectory.front().pose(), request.start)) return "it starts elsewhere";
  if (!are_same(trajectory.back().pose(), request.goal)) return "it ends elsewhere";
  return fault_in_drive(trajectory, place.robot, place.body, RefereeOptions().start_tolerance);
}

}  // namespace

OccupancyGrid random_grid(Random& random)
{
  constexpr double resolution = 0.05;
  OccupancyGrid grid = free_area(random.between(4.0, 7.0), random.between(4.0, 7.0), resolution);
  for (int boxes = random.whole(0, 20); boxes > 0; --boxes)
    occupy_block(grid, random.whole(0, grid.width - 1), random.whole(0, grid.height - 1), random.whole(2, 14),
                 random.whole(2, 14));
  for (int walls = random.whole(0, 3); walls > 0; --walls) add_wall(grid, random);
  return grid;
}

Place::Place(const OccupancyGrid& occupancy, const Robot& its_robot, const PlannerOptions& options)
  : robot(its_robot),
    grid(at_origin(occupancy)),
    world(grid, robot, options),
    body(grid, robot, options.obstacles),
    flood(grid, options.obstacles, robot, robot.safety_margin + RectangleFlood::half_step(robot))
{}

Pose Place::pose(Random& random) const
{
  const bool any = random.chance(0.03);
  for (int trial = 0;; ++trial)
  {
    const Pose pose = flood.nearest({random.between(0.0, grid.width * grid.resolution),
                                     random.between(0.0, grid.height * grid.resolution), random.angle()});
    if (any || trial > 1000 || !body.collides(pose)) return pose;
  }
}

PlanRequest Place::request(Random& random) const
{
  PlanRequest request;
  request.start = pose(random);
  request.goal = pose(random);
  const std::vector<ModeSet> sets = all_mode_sets();
  if (random.chance(0.5))
    request.modes = sets[static_cast<std::size_t>(random.whole(0, static_cast<int>(sets.size()) - 1))];
  return request;
}

/// The flood turns the body. Parallel motion alone does not, so that a way of the flood says nothing about it.
bool flood_can_judge(const ModeSet& modes)
{
  return modes.contains(Mode::ackermann) || modes.contains(Mode::lateral);
}

std::string fault_in_answer(const Place& place, const PlanRequest& request, const PlanResult& result)
{
  switch (result.status)
  {
    case PlanStatus::succeeded: return fault_in_trajectory(place, request, result.trajectory);
    case PlanStatus::goal_unreachable:
      return flood_can_judge(request.modes) && place.flood.joins(request.start, request.goal) ? "there is a way" : "";
    case PlanStatus::start_in_collision: return place.body.collides(request.start) ? "" : "the start is free";
    case PlanStatus::goal_in_collision: return place.body.collides(request.goal) ? "" : "the goal is free";
    case PlanStatus::no_path:
    case PlanStatus::timeout: return "";
    default: return "not to be expected of a request like this";
  }
}

}  // namespace fourwis::nightly
