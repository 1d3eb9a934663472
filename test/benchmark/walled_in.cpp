#include "walled_in.h"

#include <cmath>

#include "../support/grids.h"
#include "fourwis_navigation/vehicle/footprint.h"
#include "statistics.h"

namespace fourwis::benchmark
{
namespace
{

/// A copy of the grid in which the cells whose centres `is_wall` holds for are occupied.
template <typename IsWall>
OccupancyGrid with_wall(OccupancyGrid grid, const IsWall& is_wall)
{
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column)
    {
      const Pose centre = compose(grid.origin, {(column + 0.5) * grid.resolution, (row + 0.5) * grid.resolution, 0.0});
      if (is_wall(centre)) occupy(grid, column, row);
    }
  return grid;
}

/// Two cells thick, and with a cell of room inside for the robot to turn all the way round.
OccupancyGrid with_ring(const OccupancyGrid& grid, const Robot& robot, const Pose& goal)
{
  const TwoDiscs discs = two_discs(robot);
  const double inside = discs.offset + discs.radius + 2.0 * grid.resolution;
  return with_wall(grid, [&](const Pose& centre) {
    const double d = distance(centre, goal);
    return d >= inside && d < inside + 2.0 * grid.resolution;
  });
}

/// Two cells thick, on the bisector of start and goal.
OccupancyGrid with_bisector(const OccupancyGrid& grid, const Pose& start, const Pose& goal)
{
  return with_wall(grid, [&](const Pose& centre) {
    const double to_start = distance(centre, start), to_goal = distance(centre, goal);
    const double off = (to_start * to_start - to_goal * to_goal) / (2.0 * distance(start, goal));
    return std::abs(off) <= grid.resolution;
  });
}

void add_row(Table& table, const std::string& id, const std::string& wall, const Measurement& measurement)
{
  table.add({id, wall, to_string(measurement.result.status), fixed(median(measurement.frontend_ms), 2),
             fixed(worst(measurement.frontend_ms), 2), std::to_string(measurement.result.metrics.expansions)});
}

/// Refusals over all problems with one kind of wall.
struct Refusals
{
  std::size_t refused = 0;
  std::vector<double> medians;

  void count(const Measurement& measurement)
  {
    refused += measurement.result.status == PlanStatus::goal_unreachable;
    medians.push_back(median(measurement.frontend_ms));
  }

  std::string summary(const std::string& wall) const
  {
    return wall + ": refused as goal_unreachable " + std::to_string(refused) + "/" + std::to_string(medians.size()) +
           "; p50 " + fixed(median(medians), 2) + " ms, max " + fixed(worst(medians), 2) + " ms";
  }
};

}  // namespace

void report_walled_in(const Report& report, const Setup& setup, const std::string& title,
                      const std::vector<Problem>& problems)
{
  Table table({"problem", "wall", "status", "front end ms", "worst", "expansions"});
  Refusals ring, half;
  MapCache maps;
  for (const Problem& problem : problems)
  {
    const OccupancyGrid& grid = maps.grid(problem.map);
    const Measurement ringed = measure(setup, with_ring(grid, setup.robot, problem.goal), problem.start, problem.goal);
    const Measurement halved =
        measure(setup, with_bisector(grid, problem.start, problem.goal), problem.start, problem.goal);
    add_row(table, problem.id, "ring", ringed);
    add_row(table, problem.id, "half", halved);
    ring.count(ringed);
    half.count(halved);
  }
  report.title(title);
  report.table(table);
  report.line(ring.summary("ring") + ". " + half.summary("half"));
}

}  // namespace fourwis::benchmark
