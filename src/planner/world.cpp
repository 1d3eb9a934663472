#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/planner/planner.h"
#include "grid_frame.h"
#include "judge.h"

namespace fourwis
{

namespace
{

OccupancyGrid without_origin(OccupancyGrid grid)
{
  check_grid(grid);
  grid.origin = {};
  return grid;
}

}  // namespace

World::World(const OccupancyGrid& occupancy, const Robot& robot_model, const PlannerOptions& options)
  : World(occupancy, robot_model, options, PlanClock::now())
{}

World::World(const OccupancyGrid& occupancy, const Robot& robot_model, const PlannerOptions& options,
             PlanClock::time_point begin)
  : robot(checked(robot_model)),
    grid(without_origin(occupancy)),
    obstacles(grid, checked(options).obstacles),
    rectangles(obstacles),
    referee(grid, options.obstacles, robot_model, options.referee, occupancy.origin),
    build_ms(ms_since(begin))
{
  grid.origin = occupancy.origin;
}

std::optional<Violation> World::first_violation_from(double t, const Trajectory& accepted) const
{
  return referee.first_violation_from(t, GridFrame(grid.origin, robot).to_grid(accepted));
}

}  // namespace fourwis
