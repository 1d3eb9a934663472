// Plans, then drives a simulated robot along the trajectory: no ROS, no master, faster than real time.

#include <cstdio>
#include <string>

#include "fourwis_navigation/planner/planner.h"
#include "fourwis_navigation/sim/base_simulator.h"
#include "fourwis_navigation/track/tracker.h"
#include "fourwis_navigation/vehicle/base_link.h"

using namespace fourwis;

int main()
{
  OccupancyGrid grid;  // 8 m x 6 m, free
  grid.width = 160;
  grid.height = 120;
  grid.resolution = 0.05;
  grid.data.assign(static_cast<std::size_t>(grid.width * grid.height), 0);

  const Robot robot;
  const PlannerOptions planning;
  const Pose start = {1.0, 1.0, 0.0}, goal = {6.0, 4.5, 1.57};
  const PlanResult plan = Planner(planning).plan(World(grid, robot, planning), {start, goal, ModeSet()});
  if (plan.status != PlanStatus::succeeded)
  {
    std::printf("%s\n", plan.message.c_str());
    return 1;
  }

  const TrackOptions tracking;
  Tracker tracker(robot, tracking);
  BaseSimulator base(robot, SimulatorOptions());  // a robot of yours: send the commands to its wheels
  const BaseLink base_link(robot);  // plans are those of base_link; the tracker drives C, the centre of the wheels
  base.place(base_link.to_centre(start));
  const std::string refusal = tracker.accept(base_link.to_centre(plan.trajectory));
  if (!refusal.empty())
  {
    std::printf("refused: %s\n", refusal.c_str());
    return 1;
  }

  TrackOutput output;
  do {
    const double now = base.time();
    const Pose pose = base.pose();  // a robot of yours: from its localisation, with the stamp of that
    output = tracker.step({now, now, pose, base.wheels()});
    if (output.state == TrackState::driving)
      std::printf("%6.2f s  (%.3f, %.3f) m  %6.3f rad  %6.2f mm aside\n", now, pose.x, pose.y, pose.theta,
                  1000.0 * output.lateral_error);
    base.command(output.command);
    base.step(1.0 / tracking.controller_frequency);
  } while (output.state == TrackState::aligning || output.state == TrackState::driving ||
           output.state == TrackState::stopping);

  std::printf("%s: after %.2f s, planned %.2f s, %.2f mm from the goal\n",
              output.state == TrackState::arrived ? "arrived" : "failed", base.time(), plan.metrics.arrival_time,
              1000.0 * distance(base_link.from_centre(base.pose()), goal));
  return output.state == TrackState::arrived ? 0 : 1;
}
