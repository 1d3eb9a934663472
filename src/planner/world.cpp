#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/planner/planner.h"
#include "judge.h"

namespace fourwis
{

World::World(const OccupancyGrid& occupancy, const Robot& robot_model, const PlannerOptions& options)
  : World(occupancy, robot_model, options, PlanClock::now())
{}

World::World(const OccupancyGrid& occupancy, const Robot& robot_model, const PlannerOptions& options,
             PlanClock::time_point begin)
  : robot(checked(robot_model)),
    grid(occupancy),
    obstacles(occupancy, checked(options).obstacles),
    rectangles(obstacles),
    referee(occupancy, options.obstacles, robot_model, options.referee),
    build_ms(ms_since(begin))
{}

}  // namespace fourwis
