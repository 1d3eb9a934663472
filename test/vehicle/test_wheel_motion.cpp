#include "fourwis_navigation/vehicle/wheel_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/random.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/wheels.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 41;
constexpr double kDegree = M_PI / 180.0;
constexpr Mode kDrivenModes[] = {Mode::ackermann, Mode::lateral, Mode::parallel, Mode::spin};

/// A row of the wheel table of the CAN bridge's reference: angles [deg] and speeds for each m/s of C, the centre of the
/// wheels.
struct Row
{
  Mode mode;
  double phi;
  PerWheel angles, speeds;
};

constexpr Row kTable[] = {{Mode::ackermann, 30.0, {46.0, 21.8, -46.0, -21.8}, {0.803, 1.553, 0.803, 1.553}},
                          {Mode::lateral, 30.0, {108.2, 71.8, 157.0, 23.0}, {1.848, 1.848, 0.627, 0.627}},
                          {Mode::lateral, -30.0, {23.0, 157.0, 71.8, 108.2}, {0.627, 0.627, 1.848, 1.848}},
                          {Mode::parallel, 25.0, {25.0, 25.0, 25.0, 25.0}, {1.0, 1.0, 1.0, 1.0}},
                          {Mode::spin, 0.0, {127.4, 52.6, -127.4, -52.6}, {1.0, 1.0, 1.0, 1.0}}};

TEST(WheelMotion, IsThatOfTheWheelTable)
{
  for (const Row& row : kTable)
    for (double v : {1.0, -0.5, 0.0})
    {
      const WheelMotion wheels = wheel_motion({}, row.mode, v, row.phi * kDegree);
      for (std::size_t i = 0; i < kWheels; ++i)
      {
        EXPECT_NEAR(wheels.angle[i] / kDegree, row.angles[i], 0.06) << to_string(row.mode) << " wheel " << i;
        EXPECT_NEAR(wheels.speed[i], v * row.speeds[i], 6e-4) << to_string(row.mode) << " wheel " << i;
      }
    }
}

struct RandomWheels : testing::Test
{
  double steering(Mode mode) { return mode == Mode::spin ? 0.0 : random.steering(robot, mode); }

  /// The same motion with some wheels turned by half turns.
  WheelMotion on_any_branch(WheelMotion wheels)
  {
    for (std::size_t i = 0; i < kWheels; ++i)
      if (random.chance(0.5))
      {
        wheels.angle[i] += random.chance(0.5) ? M_PI : -M_PI;
        wheels.speed[i] = -wheels.speed[i];
      }
    return wheels;
  }

  testing::ScopedTrace trace{__FILE__, __LINE__, "seed " + std::to_string(kSeed)};
  Random random{kSeed};
  const Robot robot;
};

TEST_F(RandomWheels, RollAlongTheVelocityOfTheirAxes)
{
  for (int k = 0; k < 500; ++k)
    for (Mode mode : kDrivenModes)
    {
      const double v = random.between(-1.0, 1.0), phi = steering(mode);
      const Twist twist = body_twist(robot, mode, v, phi);
      const WheelMotion wheels = wheel_motion(robot, mode, v, phi);
      const auto axes = wheel_positions(robot);
      for (std::size_t i = 0; i < kWheels; ++i)
      {
        ASSERT_NEAR(wheels.speed[i] * std::cos(wheels.angle[i]), twist.vx - twist.omega * axes[i].y, 1e-12);
        ASSERT_NEAR(wheels.speed[i] * std::sin(wheels.angle[i]), twist.vy + twist.omega * axes[i].x, 1e-12);
      }
    }
}

TEST_F(RandomWheels, HaveTheirAnglesAtRestAndBackwardToo)
{
  for (Mode mode : kDrivenModes)
  {
    const double phi = steering(mode);
    const WheelMotion ahead = wheel_motion(robot, mode, 0.4, phi), back = wheel_motion(robot, mode, -0.4, phi);
    EXPECT_EQ(wheel_motion(robot, mode, 0.0, phi).angle, ahead.angle);
    EXPECT_EQ(back.angle, ahead.angle);
    for (std::size_t i = 0; i < kWheels; ++i) EXPECT_EQ(back.speed[i], -ahead.speed[i]);
  }
}

TEST_F(RandomWheels, TellTheMotionOfTheModeOnAnyBranch)
{
  for (int k = 0; k < 500; ++k)
    for (Mode mode : kDrivenModes)
    {
      const double v = random.between(-1.0, 1.0), phi = steering(mode);
      const ModeMotion motion = mode_motion(robot, mode, on_any_branch(wheel_motion(robot, mode, v, phi)), phi + 0.3);
      ASSERT_NEAR(motion.v, v, 1e-12) << to_string(mode) << " " << phi;
      ASSERT_NEAR(motion.phi, phi, 1e-12) << to_string(mode) << " " << v;
    }
}

TEST_F(RandomWheels, TellPhiAtRest)
{
  for (Mode mode : kDrivenModes)
  {
    const double phi = steering(mode);
    EXPECT_NEAR(mode_motion(robot, mode, wheel_motion(robot, mode, 0.0, phi), phi).phi, phi, 1e-12);
  }
}

TEST_F(RandomWheels, TellTheParallelAngleNearestToTheOneAskedFor)
{
  const WheelMotion wheels = wheel_motion(robot, Mode::parallel, 0.5, 0.2);
  for (int half_turns : {-2, -1, 0, 1, 2})
  {
    const ModeMotion motion = mode_motion(robot, Mode::parallel, wheels, half_turns * M_PI + 0.4);
    EXPECT_NEAR(motion.phi, 0.2 + half_turns * M_PI, 1e-12);
    EXPECT_NEAR(motion.v, half_turns % 2 == 0 ? 0.5 : -0.5, 1e-12);
  }
}

/// What the estimate of phi minimises: the velocity of the wheels across their headings, per speed of C.
double side_slip(const Robot& robot, Mode mode, const PerWheel& angles, double phi)
{
  const Twist twist = body_twist(robot, mode, 1.0, phi);
  const auto axes = wheel_positions(robot);
  double sum = 0.0;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const double vx = twist.vx - twist.omega * axes[i].y, vy = twist.vy + twist.omega * axes[i].x;
    sum += std::pow(vy * std::cos(angles[i]) - vx * std::sin(angles[i]), 2);
  }
  return sum;
}

TEST_F(RandomWheels, ThatDisagreeAreExplainedWithTheLeastSideSlip)
{
  for (int k = 0; k < 300; ++k)
  {
    const Mode mode = random.mode();
    WheelMotion wheels = wheel_motion(robot, mode, 1.0, steering(mode));
    for (double& angle : wheels.angle) angle += random.between(-0.2, 0.2);
    const double phi = mode_motion(robot, mode, wheels).phi, least = side_slip(robot, mode, wheels.angle, phi);
    for (double other = -1.5; other <= 1.5; other += 0.01)
      ASSERT_LE(least, side_slip(robot, mode, wheels.angle, other) + 1e-12) << to_string(mode) << " " << other;
  }
}

TEST_F(RandomWheels, AreSlowedDownByOneFactor)
{
  for (int k = 0; k < 300; ++k)
  {
    WheelMotion wheels;
    for (double& speed : wheels.speed) speed = random.between(-4.0, 4.0);
    const WheelMotion wanted = wheels;
    const double factor = limit_speeds(wheels, 2.0);
    double fastest = 0.0, fastest_wanted = 0.0;
    for (std::size_t i = 0; i < kWheels; ++i)
    {
      ASSERT_EQ(wheels.speed[i], wanted.speed[i] * factor);
      fastest = std::max(fastest, std::abs(wheels.speed[i]));
      fastest_wanted = std::max(fastest_wanted, std::abs(wanted.speed[i]));
    }
    ASSERT_NEAR(fastest, std::min(fastest_wanted, 2.0), 1e-12);
  }
}

TEST(WheelMotion, OfNoModeIsRest)
{
  const WheelMotion wheels = wheel_motion({}, Mode::none, 1.0, 0.3);
  EXPECT_EQ(wheels.speed, PerWheel{});
  EXPECT_EQ(mode_motion({}, Mode::none, wheel_motion({}, Mode::ackermann, 1.0, 0.3)).v, 0.0);
}

}  // namespace
}  // namespace fourwis
