#include "fourwis_navigation/vehicle/base_link.h"

#include <gtest/gtest.h>

#include "../support/random.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 17;

Robot with_base_offset(double x, double y)
{
  Robot robot;
  robot.base_offset = {x, y};
  return robot;
}

TEST(BaseLinkFrame, AtTheRearAxleTheCentreIsAhead)
{
  const BaseLink base_link(with_base_offset(0.34, 0.1));
  const Pose centre = base_link.to_centre(Pose{2.0, 1.0, M_PI_2});
  EXPECT_NEAR(centre.x, 1.9, 1e-15);
  EXPECT_NEAR(centre.y, 1.34, 1e-15);
  EXPECT_EQ(centre.theta, M_PI_2);
}

TEST(BaseLinkFrame, ThereAndBackIsTheSame)
{
  Random random(kSeed);
  for (int k = 0; k < 1000; ++k)
  {
    const BaseLink base_link(with_base_offset(random.unit(), random.unit()));
    const Pose pose = random.pose(50.0), back = base_link.from_centre(base_link.to_centre(pose));
    ASSERT_LT(distance(back, pose), 1e-13);
    ASSERT_EQ(back.theta, pose.theta);
    const Twist twist = {random.unit(), random.unit(), random.unit()},
                again = base_link.to_centre(base_link.from_centre(twist));
    ASSERT_NEAR(again.vx, twist.vx, 1e-15);
    ASSERT_NEAR(again.vy, twist.vy, 1e-15);
    ASSERT_EQ(again.omega, twist.omega);
  }
}

TEST(BaseLinkFrame, AtTheCentreChangesNoBit)
{
  const BaseLink base_link{Robot()};
  Random random(kSeed);
  for (int k = 0; k < 1000; ++k)
  {
    const Pose pose = random.pose(1e6);
    for (const Pose& same : {base_link.to_centre(pose), base_link.from_centre(pose)})
    {
      ASSERT_EQ(same.x, pose.x);
      ASSERT_EQ(same.y, pose.y);
      ASSERT_EQ(same.theta, pose.theta);
    }
  }
}

/// Its velocity is the difference of its places over a short time.
TEST(BaseLinkFrame, TwistIsHowItMoves)
{
  Random random(kSeed);
  constexpr double kTime = 1e-6;
  for (int k = 0; k < 200; ++k)
  {
    const BaseLink base_link(with_base_offset(random.unit(), random.unit()));
    const Twist twist = {random.unit(), random.unit(), random.unit()};
    const Pose before = base_link.from_centre(Pose{}), after = base_link.from_centre(move({}, twist, kTime));
    const Twist seen = base_link.from_centre(twist);
    ASSERT_NEAR((after.x - before.x) / kTime, seen.vx, 1e-5);
    ASSERT_NEAR((after.y - before.y) / kTime, seen.vy, 1e-5);
    ASSERT_EQ(seen.omega, twist.omega);
  }
}

/// Against the spread of many samples.
TEST(BaseLinkFrame, CovarianceIsThatOfItsOwnPose)
{
  const BaseLink base_link(with_base_offset(0.8, -0.3));
  Odometry centre;
  centre.pose = {1.0, 2.0, 0.7};
  centre.pose_covariance = Eigen::Vector3d(1e-4, 4e-4, 9e-4).asDiagonal();
  centre.motion.covariance = Eigen::Vector3d(1e-4, 4e-4, 9e-4).asDiagonal();
  const Odometry seen = base_link.from_centre(centre);
  Random random(kSeed);
  constexpr int kSamples = 200000;
  Eigen::Matrix3d pose = Eigen::Matrix3d::Zero(), twist = Eigen::Matrix3d::Zero();
  for (int k = 0; k < kSamples; ++k)
  {
    const double e[] = {random.normal(0.01), random.normal(0.02), random.normal(0.03)};
    const Pose off = base_link.from_centre(Pose{1.0 + e[0], 2.0 + e[1], 0.7 + e[2]});
    const Eigen::Vector3d d(off.x - seen.pose.x, off.y - seen.pose.y, off.theta - seen.pose.theta);
    pose += d * d.transpose() / kSamples;
    const Twist moved = base_link.from_centre(Twist{e[0], e[1], e[2]});
    const Eigen::Vector3d v(moved.vx, moved.vy, moved.omega);
    twist += v * v.transpose() / kSamples;
  }
  EXPECT_LT((pose - seen.pose_covariance).norm(), 0.02 * pose.norm()) << pose << "\n" << seen.pose_covariance;
  EXPECT_LT((twist - seen.motion.covariance).norm(), 0.02 * twist.norm());
}

TEST(BaseLinkFrame, TrajectoriesKeepAllButTheirPoses)
{
  const BaseLink base_link(with_base_offset(0.34, 0.0));
  TrajectoryPoint point;
  point.t = 1.5, point.mode = Mode::lateral, point.x = 3.0, point.v = 0.5, point.phi = 0.1, point.a = 2.0,
  point.omega = -1.0;
  const Trajectory moved = base_link.to_centre(Trajectory{point});
  ASSERT_EQ(moved.size(), 1u);
  EXPECT_EQ(moved[0].x, 3.34);
  EXPECT_EQ(moved[0].mode, Mode::lateral);
  EXPECT_EQ(moved[0].t, 1.5);
  EXPECT_EQ(moved[0].v, 0.5);
  EXPECT_EQ(moved[0].phi, 0.1);
  EXPECT_EQ(moved[0].a, 2.0);
  EXPECT_EQ(moved[0].omega, -1.0);
  EXPECT_EQ(base_link.from_centre(moved)[0].x, 3.0);
}

}  // namespace
}  // namespace fourwis
