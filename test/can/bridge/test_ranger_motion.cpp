#include "can/bridge/ranger_motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "../../support/random.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"

namespace fourwis::can
{
namespace
{

const Robot kRobot;

TEST(RangerMotion, IsTheSameWhicheverBranchesTheWheelsAreOn)
{
  Random random(13);
  const RangerKinematics kinematics(kRobot, {});
  for (int i = 0; i < 2000; ++i)
    for (const Mode mode : {Mode::ackermann, Mode::lateral, Mode::parallel, Mode::spin})
    {
      const double most = mode == Mode::parallel ? 1.4 : mode == Mode::ackermann ? 0.5 : 0.0;
      const double phi = random.between(-most, most);
      const WheelMotion wheels = wheel_motion(kRobot, mode, random.between(-1.0, 1.0), phi);
      WheelMotion flipped = wheels;
      for (std::size_t w = 0; w < kWheels; ++w)
      {
        if (random.chance(0.5)) continue;
        flipped.angle[w] += flipped.angle[w] > 0.0 ? -M_PI : M_PI;
        flipped.speed[w] = -flipped.speed[w];
      }
      const RangerMotion a = kinematics.base_motion(mode, wheels), b = kinematics.base_motion(mode, flipped);
      EXPECT_NEAR(a.speed, b.speed, 1e-9);
      EXPECT_NEAR(a.yaw, b.yaw, 1e-9);
      EXPECT_NEAR(a.lateral, b.lateral, 1e-9);
      EXPECT_NEAR(a.steering, b.steering, 1e-9);
    }
}

TEST(RangerMotion, SpinOfTheMiniV2IsASpeedInTheLateralField)
{
  RangerOptions options;
  options.spin_by_speed = true;
  const RangerMotion motion =
      RangerKinematics(kRobot, options).base_motion(Mode::spin, wheel_motion(kRobot, Mode::spin, 0.3, 0.0));
  EXPECT_NEAR(motion.lateral, 0.3, 1e-9);
  EXPECT_EQ(motion.yaw, 0.0);
}

TEST(RangerMotion, SideSlipHasTheNumberOfTheBase)
{
  RangerOptions options;
  options.side_slip_mode = 3;
  EXPECT_EQ(static_cast<int>(RangerKinematics(kRobot, options).base_mode(Mode::lateral)), 3);
}

TEST(RangerMotion, WhatIsMeasuredIsInOurOrderOnTheBranchThatWasCommanded)
{
  RangerOptions options;
  options.place = {2, 1, 4, 3};
  const RangerKinematics kinematics(kRobot, options);
  const WheelMotion motion =
      kinematics.measured({0.1, 0.2, 0.3, 0.4}, {1.0, 2.0, 3.0, 4.0}, {0.2, 0.1 + M_PI, 0.5, 0.3 - M_PI});
  const PerWheel angles = {0.2, 0.1 + M_PI, 0.4, 0.3 - M_PI}, speeds = {2.0, -1.0, 4.0, -3.0};
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    EXPECT_NEAR(motion.angle[i], angles[i], 1e-12);
    EXPECT_NEAR(motion.speed[i], speeds[i], 1e-12);
  }
}

}  // namespace
}  // namespace fourwis::can
