#include <cmath>

#include <gtest/gtest.h>

#include "ros/base_topics.h"
#include "ros/conversions.h"

namespace fourwis
{
namespace
{

Odometry some_odometry()
{
  Odometry odometry;
  odometry.pose = {1.0, -2.0, 0.5};
  odometry.pose_covariance << 1, 2, 3, 2, 5, 6, 3, 6, 9;
  odometry.motion.twist = {0.1, 0.2, 0.3};
  odometry.motion.covariance << 10, 20, 30, 20, 50, 60, 30, 60, 90;
  return odometry;
}

TEST(BaseTopics, odometry_is_of_the_base_in_the_odom_frame)
{
  BaseFrames frames;
  frames.odom_frame = "wheels";
  frames.robot_base_frame = "base";
  const nav_msgs::Odometry message = to_message(some_odometry(), ros::Time(7.5), frames);
  EXPECT_EQ(message.header.stamp, ros::Time(7.5));
  EXPECT_EQ(message.header.frame_id, "wheels");
  EXPECT_EQ(message.child_frame_id, "base");
  const Pose pose = to_pose(message.pose.pose, "odom");
  EXPECT_EQ(pose.x, 1.0);
  EXPECT_EQ(pose.y, -2.0);
  EXPECT_NEAR(pose.theta, 0.5, 1e-12);
  EXPECT_EQ(message.twist.twist.linear.x, 0.1);
  EXPECT_EQ(message.twist.twist.linear.y, 0.2);
  EXPECT_EQ(message.twist.twist.angular.z, 0.3);
}

TEST(BaseTopics, covariances_are_those_of_x_y_and_yaw)
{
  const Odometry odometry = some_odometry();
  const nav_msgs::Odometry message = to_message(odometry, {}, {});
  const auto at = [](const boost::array<double, 36>& covariance, int row, int column) {
    return covariance[static_cast<std::size_t>(row * 6 + column)];
  };
  constexpr int place[3] = {0, 1, 5};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
    {
      EXPECT_EQ(at(message.pose.covariance, place[row], place[column]), odometry.pose_covariance(row, column));
      EXPECT_EQ(at(message.twist.covariance, place[row], place[column]), odometry.motion.covariance(row, column));
    }
  for (const int other : {2, 3, 4})
  {
    EXPECT_GT(at(message.pose.covariance, other, other), 0.0) << "a filter may want to invert it";
    EXPECT_EQ(at(message.pose.covariance, other, 0), 0.0);
  }
}

}  // namespace
}  // namespace fourwis
