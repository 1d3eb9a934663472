#include "fourwis_navigation/vehicle/mode_limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/random.h"
#include "../support/sentences.h"
#include "fourwis_navigation/model/point.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 52;
constexpr double kDegree = M_PI / 180.0;
/// The limits keep a little reserve for rounding [rad].
constexpr double kReserve = 3e-7;

Robot with_travel(double travel)
{
  Robot robot;
  robot.wheel_max_angle = travel;
  return robot;
}

/// Velocity of a wheel's axis for v = 1.
Point2 wheel_velocity(const Robot& robot, Mode mode, double phi, const WheelPosition& wheel)
{
  const double base = mode == Mode::lateral ? robot.track_width : robot.wheelbase;
  const double turn = mode == Mode::parallel ? 0.0 : 2.0 * std::tan(phi) / base;
  const double course = mode == Mode::lateral ? M_PI_2 : mode == Mode::parallel ? phi : 0.0;
  return {std::cos(course) - turn * wheel.y, std::sin(course) + turn * wheel.x};
}

/// Whether each wheel has a branch on which it stays within its travel, to 1e-9 rad, all the way from -phi to phi.
bool wheels_follow(const Robot& robot, Mode mode, double phi)
{
  constexpr int kSteps = 400;
  for (const WheelPosition& wheel : wheel_positions(robot))
  {
    double low = INFINITY, high = -INFINITY, angle = 0.0;
    for (int k = 0; k <= kSteps; ++k)
    {
      const Point2 velocity = wheel_velocity(robot, mode, -phi + 2.0 * phi * k / kSteps, wheel);
      const double next = std::atan2(velocity.y, velocity.x);
      angle = k == 0 ? next : angle + std::remainder(next - angle, M_PI);
      low = std::min(low, angle);
      high = std::max(high, angle);
    }
    bool has_branch = false;
    for (int k = -4; k <= 4; ++k)
      has_branch |= std::max(high + k * M_PI, -low - k * M_PI) <= robot.wheel_max_angle + 1e-9;
    if (!has_branch) return false;
  }
  return true;
}

TEST(DriveLimits, OfTheDefaultRobotAreItsSteeringAngleAndItsTravel)
{
  const Robot robot;
  const DriveLimits limits(robot);
  EXPECT_EQ(limits.possible(), ModeSet());
  EXPECT_EQ(limits[Mode::ackermann].phi, robot.max_steering_angle);
  EXPECT_EQ(limits[Mode::lateral].phi, robot.max_steering_angle);
  EXPECT_EQ(limits[Mode::parallel].phi, robot.wheel_max_angle);
  EXPECT_NEAR(limits[Mode::ackermann].curvature, 2.0 * std::tan(M_PI / 6.0) / 0.68, 1e-12);
  EXPECT_NEAR(limits[Mode::lateral].curvature, 2.0 * std::tan(M_PI / 6.0) / 0.52, 1e-12);
  EXPECT_EQ(limits[Mode::parallel].curvature, 0.0);
  EXPECT_TRUE(limitations(robot).empty());
}

/// The wheel on the inside turns most: tan(delta) = t / (1 - t W / L) with t = tan(phi).
TEST(DriveLimits, AreThoseOfTheWheelOnTheInsideInAckermannMotion)
{
  for (double travel : {45.0 * kDegree, 0.8, 20.0 * kDegree, 1.0 * kDegree})
  {
    const Robot robot = with_travel(travel);
    const double t = std::tan(travel) / (1.0 + robot.track_width / robot.wheelbase * std::tan(travel));
    const ModeLimits limits = DriveLimits(robot)[Mode::ackermann];
    EXPECT_TRUE(limits.possible);
    EXPECT_NEAR(limits.phi, std::atan(t), kReserve) << travel;
    EXPECT_LE(limits.phi, std::atan(t)) << travel;
    EXPECT_NEAR(limits.curvature, 2.0 * t / robot.wheelbase, 1e-5) << travel;
  }
  EXPECT_LT(DriveLimits(with_travel(45.0 * kDegree))[Mode::ackermann].phi, Robot().max_steering_angle);
}

TEST(DriveLimits, LeaveOutLateralMotionBelowAQuarterTurn)
{
  for (double degrees : {41.0, 45.0, 85.0, 89.9})
  {
    const DriveLimits limits(with_travel(degrees * kDegree));
    EXPECT_FALSE(limits[Mode::lateral].possible) << degrees;
    EXPECT_EQ(limits.possible(), (ModeSet{Mode::ackermann, Mode::parallel})) << degrees;
    EXPECT_NEAR(limits[Mode::parallel].phi, degrees * kDegree, kReserve);
  }
}

/// At 100 degrees a wheel has 10 degrees beyond the quarter turn. Of its two branches each takes the one on which it turns as
/// the outer wheel beyond it: tan(10 deg) = t / (1 + t L / W).
TEST(DriveLimits, TakeTheBetterOfTwoBranchesInLateralMotion)
{
  for (double beyond : {10.0 * kDegree, 2.0 * kDegree})
  {
    const Robot robot = with_travel(M_PI_2 + beyond);
    const double ratio = robot.wheelbase / robot.track_width;
    const double outer = std::tan(beyond) / (1.0 - ratio * std::tan(beyond));
    const ModeLimits limits = DriveLimits(robot)[Mode::lateral];
    EXPECT_TRUE(limits.possible);
    EXPECT_NEAR(limits.phi, std::atan(outer), kReserve);
  }
  EXPECT_EQ(DriveLimits(with_travel(100.0 * kDegree))[Mode::ackermann].phi, Robot().max_steering_angle);
}

TEST(DriveLimits, AreTheGreatestThatTheWheelsCanFollow)
{
  Random random(kSeed);
  int limited = 0;
  for (int k = 0; k < 400; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", robot " + std::to_string(k));
    Robot robot;
    robot.wheelbase = random.between(0.1, 1.0);
    robot.track_width = random.between(0.1, 0.6);
    robot.max_steering_angle = random.between(10.0, 80.0) * kDegree;
    robot.wheel_max_angle = random.between(41.0, 180.0) * kDegree;
    const DriveLimits limits(robot);
    for (Mode mode : {Mode::ackermann, Mode::lateral})
    {
      const ModeLimits& limit = limits[mode];
      ASSERT_EQ(limit.possible, wheels_follow(robot, mode, 0.0)) << to_string(mode);
      if (!limit.possible) continue;
      ASSERT_LE(limit.phi, robot.max_steering_angle);
      ASSERT_TRUE(wheels_follow(robot, mode, limit.phi)) << to_string(mode) << ' ' << limit.phi;
      if (limit.phi == robot.max_steering_angle) continue;
      ++limited;
      ASSERT_FALSE(wheels_follow(robot, mode, limit.phi + 1e-6)) << to_string(mode) << ' ' << limit.phi;
    }
  }
  EXPECT_GT(limited, 150);
}

TEST(Limitations, NameTheModesLeftOutAndTheAnglesOutOfReach)
{
  const std::vector<std::string> at_85 = limitations(with_travel(85.0 * kDegree));
  ASSERT_EQ(at_85.size(), 1u);
  EXPECT_TRUE(says(at_85.front(), "lateral motion is left out"));
  EXPECT_TRUE(says(at_85.front(), "'wheel_max_angle' = 1.484 rad"));
  const std::vector<std::string> at_45 = limitations(with_travel(45.0 * kDegree));
  ASSERT_EQ(at_45.size(), 2u);
  EXPECT_TRUE(says(at_45.front(),
                   "ackermann motion steers by 0.5155 rad at most instead of 'max_steering_angle' = 0.5236 rad"));
  EXPECT_TRUE(says(at_45.back(), "lateral motion is left out"));
}

TEST(GreatestSpeed, IsWhereTheFirstWheelOrTheRobotIsAtItsLimit)
{
  Random random(kSeed);
  int by_wheel = 0, by_robot = 0;
  for (int k = 0; k < 1000; ++k)
  {
    Robot robot;
    robot.wheelbase = random.between(0.1, 1.0);
    robot.track_width = random.between(0.1, 0.6);
    robot.max_steering_angle = 80.0 * kDegree;
    robot.wheel_max_speed = random.between(0.5, 4.0);
    const Mode mode = random.mode();
    const double phi = random.steering(robot, mode);
    double ratio = 0.0;
    for (const WheelPosition& wheel : wheel_positions(robot))
    {
      const Point2 velocity = wheel_velocity(robot, mode, phi, wheel);
      ratio = std::max(ratio, std::hypot(velocity.x, velocity.y));
    }
    const double speed = greatest_speed(robot, mode, phi);
    ASSERT_NEAR(speed, std::min(robot.max_speed, robot.wheel_max_speed / ratio), 1e-12);
    ++(speed < robot.max_speed ? by_wheel : by_robot);
  }
  EXPECT_GT(by_wheel, 100);
  EXPECT_GT(by_robot, 100);
}

}  // namespace
}  // namespace fourwis
