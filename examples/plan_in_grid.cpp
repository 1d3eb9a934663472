// Plans in a grid of one's own: sideways into a niche that is hardly longer than the robot.

#include <cstdio>

#include "fourwis_navigation/planner/planner.h"

using namespace fourwis;

int main()
{
  // 6 m x 4 m in cells of 5 cm: free (0) below y = 3 m, occupied (100) above, with a niche of 1.2 m x 0.8 m.
  OccupancyGrid grid;
  grid.width = 120;
  grid.height = 80;
  grid.resolution = 0.05;
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column)
      grid.data.push_back(row < 60 || (row < 76 && column >= 60 && column < 84) ? 0 : 100);

  const Robot robot;             // a body of 1.00 m x 0.62 m, as in config/robot.yaml
  const PlannerOptions options;  // as in config/planner.yaml
  const World world(grid, robot, options);
  const PlanRequest request = {{1.0, 1.0, 0.0}, {3.6, 3.4, 0.0}, ModeSet()};  // start and goal: x, y [m], theta [rad]
  const PlanResult plan = Planner(options).plan(world, request);

  for (const TrajectoryPoint& p : plan.trajectory)
    std::printf("%6.2f s  %-9s  (%.3f, %.3f) m  %6.3f rad  %6.3f m/s\n", p.t, to_string(p.mode), p.x, p.y, p.theta,
                p.v);
  std::printf("%s: %.2f m in %.2f s, %d mode switches, at least %.3f m from all obstacles\n", to_string(plan.status),
              plan.metrics.length, plan.metrics.arrival_time, plan.metrics.switches, plan.metrics.min_clearance);
  if (plan.status == PlanStatus::succeeded) return 0;
  std::printf("%s\n", plan.message.c_str());
  return 1;
}
