#pragma once

#include "planner_fixture.h"
#include "simulated_drive.h"

namespace fourwis
{

/// Goals come to the planner, and the simulated robot drives there.
class PlannedDrive : public PlannerFixture, protected SimulatedDrive
{
protected:
  /// Returns when the robot is fast on its way there.
  void drive_towards(const Pose& goal)
  {
    send_goal(goal);
    const auto trajectory = trajectories_.wait_for([](const ModeTrajectory& t) { return !t.points.empty(); });
    ASSERT_TRUE(trajectory);
    wait_for_motion(trajectory->header.stamp);
    trajectories_.clear();
  }

  void expect_arrival(const Pose& goal)
  {
    ASSERT_TRUE(wait_for_status("arrived", goal));
    expect_at(goal);
  }
};

}  // namespace fourwis
