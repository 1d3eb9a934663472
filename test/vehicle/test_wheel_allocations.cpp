// The functions for the wheels that each control step calls do not allocate memory.

#include <gtest/gtest.h>

#include "../support/allocations.h"
#include "fourwis_navigation/vehicle/wheel_branches.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"
#include "fourwis_navigation/vehicle/wheel_odometry.h"

namespace fourwis
{
namespace
{

TEST(WheelSteps, DoNotAllocate)
{
  const Robot robot;
  WheelOdometry odometry(robot, {});
  PerWheel angle = choose_branches(robot, {Mode::lateral, 0.0, 0.0, 0.5}, {}).motion.angle;
  const long before = allocations;
  EXPECT_GT(before, 0);
  for (int k = 0; k < 100; ++k)
  {
    const ModeMotion wanted{0.5, 0.005 * k};
    BranchedMotion branched = continue_branches(robot, wheel_motion(robot, Mode::lateral, wanted.v, wanted.phi), angle);
    limit_speeds(branched.motion, robot.wheel_max_speed);
    angle = branched.motion.angle;
    WheelMotion measured = branched.motion;
    if (k % 2 == 0) measured.speed[1] += 1.0;
    odometry.update(0.01 * k, measured);
    EXPECT_EQ(odometry.state().motion.left_out, k % 2 == 0 ? 1 : -1);
    EXPECT_NEAR(mode_motion(robot, Mode::lateral, branched.motion).phi, wanted.phi, 1e-9);
  }
  EXPECT_EQ(allocations - before, 0);
}

}  // namespace
}  // namespace fourwis
