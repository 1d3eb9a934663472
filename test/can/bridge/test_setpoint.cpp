#include "can/bridge/setpoint.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "../../support/random.h"

namespace fourwis::can
{
namespace
{

const Robot kRobot;
const BridgeOptions kOptions;
constexpr double kCycle = 0.01, kRounding = 1e-9;

PerWheel random_wheels(Random& random, double size)
{
  PerWheel wheels{};
  for (double& wheel : wheels) wheel = random.between(-size, size);
  return wheels;
}

TEST(Setpoint, KeepsAllLimitsForAnyTarget)
{
  Random random(11);
  Setpoint setpoint(kRobot, kOptions);
  setpoint.hold({});
  for (int i = 0; i < 20000; ++i)
  {
    const WheelMotion before = setpoint.value();
    setpoint.approach({random_wheels(random, 4.0), random_wheels(random, 5.0)}, kCycle);
    const WheelMotion& after = setpoint.value();
    EXPECT_LE(greatest_gap(after.angle, before.angle), kRobot.wheel_max_rate * kCycle + kRounding);
    EXPECT_LE(greatest_gap(after.speed, before.speed), kOptions.max_acceleration * kCycle + kRounding);
    EXPECT_LE(greatest_magnitude(after.speed), kRobot.wheel_max_speed + kRounding);
    EXPECT_LE(greatest_magnitude(after.angle), kRobot.wheel_max_angle + kRounding);
  }
}

TEST(Setpoint, ReachesWhatIsPossibleAndStaysThere)
{
  Random random(12);
  for (int i = 0; i < 200; ++i)
  {
    Setpoint setpoint(kRobot, kOptions);
    setpoint.hold({random_wheels(random, 2.7), {}});
    const WheelMotion target{random_wheels(random, 2.7), random_wheels(random, 1.9)};
    for (int cycle = 0; cycle < 200; ++cycle) setpoint.approach(target, kCycle);
    EXPECT_LT(greatest_gap(setpoint.value().angle, target.angle), kRounding);
    EXPECT_LT(greatest_gap(setpoint.value().speed, target.speed), kRounding);
  }
}

TEST(Setpoint, SpeedsAreReducedByOneFactor)
{
  Setpoint setpoint(kRobot, kOptions);
  setpoint.hold({});
  for (int cycle = 0; cycle < 100; ++cycle)
  {
    setpoint.approach({{}, {4.0, 2.0, -1.0, 0.0}}, kCycle);
    const PerWheel& speed = setpoint.value().speed;
    EXPECT_NEAR(speed[1], speed[0] / 2.0, kRounding);
    EXPECT_NEAR(speed[2], -speed[0] / 4.0, kRounding);
    EXPECT_EQ(speed[3], 0.0);
  }
  EXPECT_NEAR(setpoint.value().speed[0], kRobot.wheel_max_speed, kRounding);
}

TEST(Setpoint, AControlledStopComesToRestInTheTimeOfItsDecelerationWithTheAnglesHeld)
{
  Setpoint setpoint(kRobot, kOptions);
  setpoint.hold({});
  for (int cycle = 0; cycle < 100; ++cycle) setpoint.approach({{0.1, 0.2, 0.3, 0.4}, {1.0, 0.5, -1.0, 0.0}}, kCycle);
  const WheelMotion before = setpoint.value();
  const int cycles = static_cast<int>(std::lround(1.0 / (kOptions.stop_deceleration * kCycle)));
  for (int cycle = 1; cycle <= cycles; ++cycle)
  {
    setpoint.ramp_down(kCycle);
    EXPECT_NEAR(setpoint.value().speed[0], std::max(0.0, 1.0 - cycle * kOptions.stop_deceleration * kCycle), kRounding);
    EXPECT_NEAR(setpoint.value().speed[1], setpoint.value().speed[0] / 2.0, kRounding);
  }
  setpoint.ramp_down(kCycle);
  EXPECT_EQ(greatest_magnitude(setpoint.value().speed), 0.0);
  EXPECT_EQ(setpoint.value().angle, before.angle);
}

}  // namespace
}  // namespace fourwis::can
