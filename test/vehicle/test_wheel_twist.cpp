#include "fourwis_navigation/vehicle/wheel_twist.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "../support/random.h"
#include "../support/twist.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 43;

/// The wheels of a body that moves with the twist, on either branch; each lies `offset` to the left of its axis and
/// is steered at its rate. Position of the wheel and its derivative, written out.
WheelMotion wheels_of(const Robot& robot, const Twist& twist, Random& random, double offset = 0.0,
                      const PerWheel& rate = {})
{
  WheelMotion wheels;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const WheelPosition axis = wheel_positions(robot)[i];
    const double vx = twist.vx - twist.omega * axis.y, vy = twist.vy + twist.omega * axis.x;
    const double a = std::atan2(vy, vx) + (random.chance(0.5) ? M_PI : 0.0);
    // The wheel is at axis + offset (-sin a, cos a), and turns with the body and about its axis.
    const double turn = twist.omega + rate[i];
    const double wheel_vx = vx - turn * offset * std::cos(a), wheel_vy = vy - turn * offset * std::sin(a);
    wheels.angle[i] = a;
    wheels.speed[i] = wheel_vx * std::cos(a) + wheel_vy * std::sin(a);
  }
  return wheels;
}

struct TwistOfWheels : testing::Test
{
  Twist any_twist() { return {random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-2.0, 2.0)}; }

  testing::ScopedTrace trace{__FILE__, __LINE__, "seed " + std::to_string(kSeed)};
  Random random{kSeed};
  const Robot robot;
  const WheelTwist solver{robot, {}};
};

TEST_F(TwistOfWheels, IsTheTwistThatMadeThemRoll)
{
  for (int k = 0; k < 500; ++k)
  {
    const Twist twist = any_twist();
    const TwistEstimate estimate = solver.estimate(wheels_of(robot, twist, random));
    expect_twist(estimate.twist, twist, 1e-12);
    EXPECT_NEAR(estimate.residual, 0.0, 1e-12);
    EXPECT_EQ(estimate.left_out, -1);
  }
}

TEST_F(TwistOfWheels, IsThatOfEveryMode)
{
  for (Mode mode : {Mode::ackermann, Mode::lateral, Mode::parallel, Mode::spin})
    for (double v : {0.8, -0.3, 0.0})
      for (double phi : {0.0, 0.5, -0.5})
      {
        SCOPED_TRACE(std::string(to_string(mode)) + " v " + std::to_string(v) + " phi " + std::to_string(phi));
        expect_twist(solver.estimate(wheel_motion(robot, mode, v, phi)).twist, body_twist(robot, mode, v, phi), 1e-12);
      }
}

/// The sum that least squares minimises.
double squares(const Robot& robot, const WheelMotion& wheels, const Twist& twist)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const WheelPosition axis = wheel_positions(robot)[i];
    sum += std::pow(twist.vx - twist.omega * axis.y - wheels.speed[i] * std::cos(wheels.angle[i]), 2) +
           std::pow(twist.vy + twist.omega * axis.x - wheels.speed[i] * std::sin(wheels.angle[i]), 2);
  }
  return sum;
}

TEST_F(TwistOfWheels, ThatDisagreeLeavesTheLeastSquares)
{
  const WheelTwist tolerant(robot, {0.01, 1e3, 0.0});
  for (int k = 0; k < 200; ++k)
  {
    WheelMotion wheels;
    for (double& angle : wheels.angle) angle = random.angle();
    for (double& speed : wheels.speed) speed = random.between(-1.0, 1.0);
    const TwistEstimate estimate = tolerant.estimate(wheels);
    const double least = squares(robot, wheels, estimate.twist);
    EXPECT_NEAR(estimate.residual, std::sqrt(least / 5.0), 1e-12);
    for (int trial = 0; trial < 20; ++trial)
    {
      Twist other = estimate.twist;
      other.vx += random.between(-0.1, 0.1);
      other.vy += random.between(-0.1, 0.1);
      other.omega += random.between(-0.1, 0.1);
      EXPECT_LE(least, squares(robot, wheels, other));
    }
  }
}

TEST_F(TwistOfWheels, DoesWithoutTheOneThatLies)
{
  for (int k = 0; k < 500; ++k)
  {
    const Twist twist = any_twist();
    WheelMotion wheels = wheels_of(robot, twist, random);
    const int liar = random.whole(0, 3);
    wheels.speed[static_cast<std::size_t>(liar)] += random.chance(0.5) ? 0.8 : -0.8;
    const TwistEstimate estimate = solver.estimate(wheels);
    EXPECT_EQ(estimate.left_out, liar);
    EXPECT_NEAR(estimate.residual, 0.0, 1e-9);
    expect_twist(estimate.twist, twist, 1e-9);
  }
}

TEST_F(TwistOfWheels, LeavesOutTheWheelWithoutWhichTheOthersAgreeBest)
{
  for (int k = 0; k < 200; ++k)
  {
    WheelMotion wheels = wheels_of(robot, any_twist(), random);
    for (double& speed : wheels.speed) speed += random.between(-0.4, 0.4);
    const TwistEstimate estimate = solver.estimate(wheels);
    if (estimate.left_out < 0) continue;
    for (std::size_t other = 0; other < kWheels; ++other)
    {
      // The fourth wheel moves as the other three say it should, so its equations change nothing.
      WheelMotion consistent = wheels;
      double residual = std::numeric_limits<double>::infinity();
      for (int round = 0; round < 400; ++round)
      {
        const TwistEstimate three = WheelTwist(robot, {0.01, 1e3, 0.0}).estimate(consistent);
        const WheelPosition axis = wheel_positions(robot)[other];
        const double vx = three.twist.vx - three.twist.omega * axis.y, vy = three.twist.vy + three.twist.omega * axis.x;
        consistent.angle[other] = std::atan2(vy, vx);
        consistent.speed[other] = std::hypot(vx, vy);
        residual = three.residual * std::sqrt(5.0 / 3.0);
      }
      EXPECT_LE(estimate.residual, residual + 1e-9);
    }
  }
}

TEST_F(TwistOfWheels, WithinTheBoundLeavesNoneOut)
{
  WheelMotion wheels = wheel_motion(robot, Mode::ackermann, 1.0, 0.1);
  wheels.speed[2] *= 1.03;
  const TwistEstimate estimate = solver.estimate(wheels);
  EXPECT_EQ(estimate.left_out, -1);
  EXPECT_GT(estimate.residual, 0.005);
}

TEST_F(TwistOfWheels, KnowsThatWheelsBesideTheirAxesRollWhenSteered)
{
  for (double offset : {0.05, -0.03})
  {
    const WheelTwist offset_solver(robot, {0.01, 0.1, offset});
    for (int k = 0; k < 200; ++k)
    {
      const Twist twist = any_twist();
      const PerWheel rate = {random.between(-3.0, 3.0), random.between(-3.0, 3.0), random.between(-3.0, 3.0), 0.0};
      const TwistEstimate estimate = offset_solver.estimate(wheels_of(robot, twist, random, offset, rate), rate);
      EXPECT_EQ(estimate.left_out, -1);
      expect_twist(estimate.twist, twist, 1e-3);
    }
  }
}

TEST_F(TwistOfWheels, HasTheCovarianceThatNoiseCauses)
{
  constexpr int kSamples = 40000;
  constexpr double kDeviation = 0.02;
  const WheelTwist noisy(robot, {kDeviation, 1e3, 0.0});
  // Wheels along and across, so that noise of angles and speeds is noise of the velocities.
  const Twist twist{0.5, 0.0, 0.0};
  const WheelMotion wheels = wheel_motion(robot, Mode::parallel, 0.5, 0.0);
  Random noise(kSeed);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero(), claimed = Eigen::Matrix3d::Zero();
  for (int k = 0; k < kSamples; ++k)
  {
    WheelMotion measured = wheels;
    for (double& speed : measured.speed) speed += noise.normal(kDeviation);
    for (double& angle : measured.angle) angle += noise.normal(kDeviation) / 0.5;
    const TwistEstimate estimate = noisy.estimate(measured);
    const Eigen::Vector3d error(estimate.twist.vx - twist.vx, estimate.twist.vy - twist.vy,
                                estimate.twist.omega - twist.omega);
    scatter += error * error.transpose() / kSamples;
    claimed += estimate.covariance / kSamples;
  }
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_GT(claimed(i, i), scatter(i, i)) << "the greater of deviation and residual";
    EXPECT_LT(claimed(i, i), 1.5 * scatter(i, i));
  }
}

TEST_F(TwistOfWheels, IsLessCertainTheMoreTheyDisagree)
{
  WheelMotion wheels = wheel_motion(robot, Mode::ackermann, 1.0, 0.0);
  const Eigen::Matrix3d agreed = solver.estimate(wheels).covariance;
  EXPECT_NEAR(agreed(0, 0), 1e-4 / 4.0, 1e-12);
  EXPECT_NEAR(agreed(2, 2), 1e-4 / (robot.wheelbase * robot.wheelbase + robot.track_width * robot.track_width), 1e-12);
  wheels.speed[0] += 0.1;
  EXPECT_GT(solver.estimate(wheels).covariance(0, 0), 4.0 * agreed(0, 0));
}

TEST_F(TwistOfWheels, RejectsInvalidOptions)
{
  EXPECT_THROW(WheelTwist(robot, {-0.01, 0.1, 0.0}), std::invalid_argument);
  EXPECT_THROW(WheelTwist(robot, {0.01, NAN, 0.0}), std::invalid_argument);
  EXPECT_THROW(WheelTwist(robot, {0.01, 0.1, 0.5}), std::invalid_argument);
  Robot wide = robot;
  wide.track_width = 2.0 * wide.width;
  EXPECT_THROW(WheelTwist(wide, {}), std::invalid_argument);
}

}  // namespace
}  // namespace fourwis
