#include "fourwis_navigation/vehicle/wheel_odometry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "../support/random.h"
#include "../support/sentences.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 44;
constexpr double kInterval = 0.01;

struct OdometryOfWheels : testing::Test
{
  void drive(Mode mode, double v, double phi, int steps)
  {
    for (int k = 0; k < steps; ++k) odometry.update(stamp += kInterval, wheel_motion(robot, mode, v, phi));
  }
  void expect_pose(const Pose& expected, double accuracy)
  {
    EXPECT_LT(distance(odometry.state().pose, expected), accuracy);
    EXPECT_NEAR(odometry.state().pose.theta, expected.theta, accuracy);
  }

  const Robot robot;
  double stamp = 100.0;
  WheelOdometry odometry{robot, {}};
};

TEST_F(OdometryOfWheels, FollowsTheArcOfEveryMode)
{
  for (Mode mode : {Mode::ackermann, Mode::lateral, Mode::parallel, Mode::spin})
    for (double phi : {0.0, 0.4, -0.5})
    {
      odometry = WheelOdometry(robot, {});
      const Pose start{3.0, -1.0, 0.7};
      odometry.set_pose(start);
      drive(mode, 0.6, phi, 201);  // the first begins, each of the others is an interval
      SCOPED_TRACE(to_string(mode));
      expect_pose(move(start, body_twist(robot, mode, 0.6, phi), 2.0), 1e-9);
    }
}

TEST_F(OdometryOfWheels, TakesTheMeanOfTheTwistsOfAnInterval)
{
  constexpr double kAcceleration = 2.0;
  for (int k = 0; k <= 50; ++k)
    odometry.update(stamp + k * kInterval, wheel_motion(robot, Mode::lateral, kAcceleration * k * kInterval, 0.0));
  expect_pose({0.0, kAcceleration * 0.5 * 0.5 / 2.0, 0.0}, 1e-9);
}

TEST_F(OdometryOfWheels, RefusesWhatIsNoNumberAndStampsThatDoNotGrow)
{
  WheelMotion wheels = wheel_motion(robot, Mode::ackermann, 1.0, 0.0);
  EXPECT_EQ(odometry.update(5.0, wheels), OdometryStatus::first);
  EXPECT_EQ(odometry.update(5.0, wheels), OdometryStatus::not_newer);
  EXPECT_EQ(odometry.update(4.9, wheels), OdometryStatus::not_newer);
  for (double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
  {
    WheelMotion broken = wheels;
    broken.speed[3] = bad;
    EXPECT_EQ(odometry.update(5.1, broken), OdometryStatus::not_finite);
    broken = wheels;
    broken.angle[0] = bad;
    EXPECT_EQ(odometry.update(5.1, broken), OdometryStatus::not_finite);
    EXPECT_EQ(odometry.update(bad, wheels), OdometryStatus::not_finite);
  }
  EXPECT_EQ(odometry.state().stamp, 5.0);
  EXPECT_EQ(odometry.update(5.1, wheels), OdometryStatus::integrated);
  expect_pose({0.1, 0.0, 0.0}, 1e-9);
}

TEST_F(OdometryOfWheels, DoesNotInventWhatHappenedInAGap)
{
  const WheelMotion wheels = wheel_motion(robot, Mode::ackermann, 1.0, 0.0);
  odometry.update(5.0, wheels);
  EXPECT_EQ(odometry.update(5.6, wheels), OdometryStatus::gap);
  expect_pose({}, 1e-12);
  EXPECT_EQ(odometry.update(5.7, wheels), OdometryStatus::integrated);
  expect_pose({0.1, 0.0, 0.0}, 1e-9);
}

TEST_F(OdometryOfWheels, GoesOnFromAPoseThatItIsGiven)
{
  drive(Mode::ackermann, 1.0, 0.3, 50);
  odometry.set_pose({1.0, 2.0, M_PI_2});
  EXPECT_EQ(odometry.state().pose_covariance, Eigen::Matrix3d::Zero());
  drive(Mode::ackermann, 1.0, 0.0, 1);
  EXPECT_GT(odometry.state().pose.y, 2.004);
}

TEST_F(OdometryOfWheels, KnowsThatWheelsBesideTheirAxesRollWhenSteeredAtRest)
{
  constexpr double kOffset = 0.04, kRate = 1.5;
  odometry = WheelOdometry(robot, {0.01, 0.1, kOffset});
  for (int k = 0; k <= 50; ++k)
  {
    WheelMotion wheels;
    wheels.angle.fill(kRate * k * kInterval);
    wheels.speed.fill(-kOffset * kRate);
    odometry.update(stamp + k * kInterval, wheels);
  }
  // The first measurement has no rate yet. It counts for half an interval.
  expect_pose({}, kOffset * kRate * kInterval);
}

/// Scatter of the final pose of odometry with noisy wheels, and its own covariance.
TEST_F(OdometryOfWheels, HasTheCovarianceOfManyRuns)
{
  constexpr int kRuns = 600, kSteps = 200;  // the noise is so small that its square has no effect on the length
  constexpr double kDeviation = 0.01, kSpeed = 0.5;
  const WheelMotion truth = wheel_motion(robot, Mode::ackermann, kSpeed, 0.3);
  Random random(kSeed);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero(), claimed = Eigen::Matrix3d::Zero();
  const Pose end = move({}, body_twist(robot, Mode::ackermann, kSpeed, 0.3), kSteps * kInterval);
  for (int run = 0; run < kRuns; ++run)
  {
    WheelOdometry one(robot, {kDeviation, 1e3, 0.0});
    for (int k = 0; k <= kSteps; ++k)
    {
      WheelMotion wheels = truth;
      for (std::size_t i = 0; i < kWheels; ++i)
      {
        wheels.speed[i] += random.normal(kDeviation);
        wheels.angle[i] += random.normal(kDeviation) / truth.speed[i];
      }
      one.update(k * kInterval, wheels);
    }
    const Pose& pose = one.state().pose;
    const Eigen::Vector3d error(pose.x - end.x, pose.y - end.y, pose.theta - end.theta);
    scatter += error * error.transpose() / kRuns;
    claimed += one.state().pose_covariance / kRuns;
  }
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_GT(claimed(i, i), 0.9 * scatter(i, i)) << i;
    EXPECT_LT(claimed(i, i), 1.8 * scatter(i, i)) << i;
  }
  const auto correlation = [](const Eigen::Matrix3d& covariance, int i, int j) {
    return covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j));
  };
  for (const auto& [i, j] : {std::pair(0, 1), {0, 2}, {1, 2}})
  {
    EXPECT_GT(std::abs(correlation(scatter, i, j)), 0.3) << i << j;
    EXPECT_NEAR(correlation(claimed, i, j), correlation(scatter, i, j), 0.15) << i << j;
    EXPECT_NEAR(claimed(i, j), claimed(j, i), 1e-12);
  }
}

/// With a wheel left out, the errors of the twist are correlated.
TEST_F(OdometryOfWheels, TurnsTheCovarianceOfTheTwistIntoItsFrame)
{
  WheelMotion wheels = wheel_motion(robot, Mode::ackermann, 0.5, 0.3);
  wheels.speed[1] += 1.0;  // slips
  odometry.set_pose({1.0, 2.0, 0.7});
  odometry.update(5.0, wheels);
  odometry.update(5.1, wheels);
  const TwistEstimate& motion = odometry.state().motion;
  ASSERT_EQ(motion.left_out, 1);
  EXPECT_GT(std::abs(motion.covariance(0, 2)), 0.3 * motion.covariance(0, 0));
  const double middle = 0.7 + motion.twist.omega * 0.05;
  Eigen::Matrix3d turn;
  turn << std::cos(middle), -std::sin(middle), 0.0, std::sin(middle), std::cos(middle), 0.0, 0.0, 0.0, 1.0;
  const Eigen::Matrix3d expected = 0.01 * turn * motion.covariance * turn.transpose();
  EXPECT_LT((odometry.state().pose_covariance - expected).norm(), 1e-6 * expected.norm());
}

TEST_F(OdometryOfWheels, TheLongestIntervalIsPositiveAndFinite)
{
  const std::vector<std::pair<double, std::string>> cases = {
      {0.0, "0"}, {-0.5, "-0.5"}, {std::nan(""), "nan"}, {std::numeric_limits<double>::infinity(), "inf"}};
  for (const auto& [longest, text] : cases)
    EXPECT_EQ(error_of<std::invalid_argument>([&, bad = longest] { WheelOdometry(robot, {}, bad); }),
              "parameter 'longest_interval' is " + text + ", expected a positive, finite number");
}

}  // namespace
}  // namespace fourwis
