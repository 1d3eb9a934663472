#include "fourwis_navigation/vehicle/wheel_branches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "../support/random.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 42;
constexpr double kDegree = M_PI / 180.0;
constexpr double kUnreachable = std::numeric_limits<double>::infinity();

/// All angles of a wheel over a stretch, from its start to both ends, in small steps without jumps.
std::vector<double> followed(const Robot& robot, const SteeringStretch& stretch, std::size_t wheel, double first)
{
  constexpr int kSteps = 100;
  std::vector<double> angles;
  for (double end : {stretch.low, stretch.high})
  {
    double angle = first;
    for (int k = 0; k <= kSteps; ++k)
    {
      const double phi = stretch.start + (end - stretch.start) * k / kSteps;
      angle += std::remainder(wheel_motion(robot, stretch.mode, 1.0, phi).angle[wheel] - angle, M_PI);
      angles.push_back(angle);
    }
  }
  return angles;
}

/// The least turn at standstill from the measured angle to a branch within the travel. All half turns are tried.
double least_turn(const Robot& robot, const SteeringStretch& stretch, std::size_t wheel, double measured)
{
  double least = kUnreachable;
  for (int k = -4; k <= 4; ++k)
  {
    const double first = wheel_motion(robot, stretch.mode, 1.0, stretch.start).angle[wheel] + k * M_PI;
    const std::vector<double> angles = followed(robot, stretch, wheel, first);
    const bool within = std::all_of(angles.begin(), angles.end(),
                                    [&](double angle) { return std::abs(angle) <= robot.wheel_max_angle + 1e-9; });
    if (within) least = std::min(least, std::abs(first - measured));
  }
  return least;
}

struct Branches : testing::Test
{
  SteeringStretch any_stretch()
  {
    const Mode mode = random.chance(0.2) ? Mode::spin : random.mode();
    const double limit = mode == Mode::parallel ? M_PI : robot.max_steering_angle;
    double phi[] = {random.between(-limit, limit), random.between(-limit, limit), random.between(-limit, limit)};
    std::sort(std::begin(phi), std::end(phi));
    return {mode, phi[1], phi[0], phi[2]};
  }
  PerWheel any_angles()
  {
    PerWheel angles{};
    for (double& angle : angles) angle = random.between(-robot.wheel_max_angle, robot.wheel_max_angle);
    return angles;
  }

  testing::ScopedTrace trace{__FILE__, __LINE__, "seed " + std::to_string(kSeed)};
  Random random{kSeed};
  Robot robot;
};

TEST_F(Branches, ChosenAtRestAreTheNearestThatStayWithinTheTravel)
{
  int possible = 0, impossible = 0;
  for (int k = 0; k < 400; ++k)
  {
    robot.wheel_max_angle = random.between(85.0, 250.0) * kDegree;
    robot.max_steering_angle = random.between(20.0, 75.0) * kDegree;
    const SteeringStretch stretch = any_stretch();
    const PerWheel measured = any_angles();
    const BranchedMotion chosen = choose_branches(robot, stretch, measured);
    int first_beyond = -1;
    for (std::size_t i = 0; i < kWheels; ++i)
    {
      const double least = least_turn(robot, stretch, i, measured[i]);
      if (least == kUnreachable && first_beyond < 0) first_beyond = static_cast<int>(i);
      if (least == kUnreachable) continue;
      ASSERT_NEAR(std::abs(chosen.motion.angle[i] - measured[i]), least, 1e-9);
    }
    ASSERT_EQ(chosen.beyond.has_value(), first_beyond >= 0) << to_string(stretch.mode);
    ++(chosen.beyond ? impossible : possible);
    if (!chosen.beyond) continue;
    ASSERT_EQ(chosen.beyond->wheel, first_beyond);
    ASSERT_GT(std::abs(chosen.beyond->angle), robot.wheel_max_angle);
  }
  EXPECT_GT(possible, 100);
  EXPECT_GT(impossible, 20);
}

TEST_F(Branches, ChosenAtRestAreContinuedOverTheWholeStretchWithoutLeavingTheTravel)
{
  for (int k = 0; k < 300; ++k)
  {
    const SteeringStretch stretch = any_stretch();
    const BranchedMotion chosen = choose_branches(robot, stretch, any_angles());
    if (chosen.beyond) continue;
    for (double end : {stretch.low, stretch.high})
    {
      PerWheel angle = chosen.motion.angle;
      for (int step = 0; step <= 100; ++step)
      {
        const double phi = stretch.start + (end - stretch.start) * step / 100.0;
        const WheelMotion wanted = wheel_motion(robot, stretch.mode, 0.7, phi);
        const BranchedMotion next = continue_branches(robot, wanted, angle);
        ASSERT_FALSE(next.beyond);
        for (std::size_t i = 0; i < kWheels; ++i) ASSERT_LT(std::abs(next.motion.angle[i] - angle[i]), 0.4);
        const ModeMotion motion = mode_motion(robot, stretch.mode, next.motion, phi);
        ASSERT_NEAR(motion.v, 0.7, 1e-9);
        ASSERT_NEAR(motion.phi, stretch.mode == Mode::spin ? 0.0 : phi, 1e-9);
        angle = next.motion.angle;
      }
    }
  }
}

TEST_F(Branches, ContinuedAreTheSameMotionNearestToThePreviousAngles)
{
  for (int k = 0; k < 500; ++k)
  {
    WheelMotion wanted;
    wanted.angle = any_angles();
    for (double& speed : wanted.speed) speed = random.between(-1.0, 1.0);
    const PerWheel previous = any_angles();
    const WheelMotion next = continue_branches(robot, wanted, previous).motion;
    for (std::size_t i = 0; i < kWheels; ++i)
    {
      ASSERT_LE(std::abs(next.angle[i] - previous[i]), M_PI_2 + 1e-9);
      ASSERT_NEAR(next.speed[i] * std::cos(next.angle[i]), wanted.speed[i] * std::cos(wanted.angle[i]), 1e-9);
      ASSERT_NEAR(next.speed[i] * std::sin(next.angle[i]), wanted.speed[i] * std::sin(wanted.angle[i]), 1e-9);
    }
  }
}

TEST_F(Branches, ContinuedBeyondTheTravelAreRefusedByWheelAndAngle)
{
  const BranchedMotion next =
      continue_branches(robot, {{0.0, 0.0, 170.0 * kDegree, 0.0}, {}}, {0.0, 0.0, 159.0 * kDegree, 0.0});
  ASSERT_TRUE(next.beyond);
  EXPECT_EQ(next.beyond->wheel, 2);
  EXPECT_NEAR(next.beyond->angle, 170.0 * kDegree, 1e-9);
  EXPECT_TRUE(continue_branches(robot, {{NAN, 0.0, 0.0, 0.0}, {}}, {}).beyond);
}

TEST_F(Branches, OfAWheelThatTurns90DegreesCannotCrossThem)
{
  robot.wheel_max_angle = 90.0 * kDegree;
  const double left = 20.0 * kDegree;
  EXPECT_TRUE(choose_branches(robot, {Mode::lateral, left, -left, left}, {}).beyond) << "wheels cross 90 degrees";
  EXPECT_FALSE(choose_branches(robot, {Mode::lateral, left, 0.0, left}, {}).beyond) << "they do not to one side";
  EXPECT_FALSE(choose_branches(robot, {Mode::ackermann, left, -left, left}, {}).beyond);
}

}  // namespace
}  // namespace fourwis
