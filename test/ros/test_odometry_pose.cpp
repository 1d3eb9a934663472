#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <tf2/buffer_core.h>

#include "../support/sentences.h"
#include "ros/conversions.h"
#include "ros/odometry_pose.h"

namespace fourwis
{
namespace
{

class OdometryPoseTest : public testing::Test
{
protected:
  /// The localisation says where the odom frame is in the map.
  void localize(const Pose& odom_in_map, double stamp, bool is_static = false)
  {
    std_msgs::Header header;
    header.frame_id = "map";
    header.stamp = ros::Time(stamp);
    tf_.setTransform(to_message(odom_in_map, header, "odom"), "test", is_static);
  }

  static nav_msgs::Odometry odometry(const Pose& pose, double stamp)
  {
    nav_msgs::Odometry message;
    message.header.frame_id = "odom";
    message.header.stamp = ros::Time(stamp);
    message.child_frame_id = "base_link";
    message.pose.pose = to_message(pose);
    return message;
  }

  void expect_at(const nav_msgs::Odometry& message, const Pose& expected)
  {
    const Pose pose = pose_.at(message);
    EXPECT_NEAR(pose.x, expected.x, 1e-9);
    EXPECT_NEAR(pose.y, expected.y, 1e-9);
    EXPECT_NEAR(wrap_angle(pose.theta - expected.theta), 0.0, 1e-9);
  }

  std::string rejection(const nav_msgs::Odometry& message)
  {
    return error_of<ConversionError>([&] { pose_.at(message); });
  }

  tf2::BufferCore tf_;
  OdometryPose pose_{"map", "base_link", 0.5, tf_};
};

TEST_F(OdometryPoseTest, is_the_odometry_seen_through_the_localisation)
{
  localize({1, 2, M_PI_2}, 0.0, true);
  expect_at(odometry({3, 0, 0.1}, 50.0), {1, 5, M_PI_2 + 0.1});
}

TEST_F(OdometryPoseTest, uses_the_localisation_of_the_odometrys_own_time)
{
  localize({0, 0, 0}, 10.0);
  localize({1, 0, 0}, 11.0);
  expect_at(odometry({}, 10.25), {0.25, 0, 0});
  localize({100, 0, 0}, 12.0);
  expect_at(odometry({}, 10.25), {0.25, 0, 0});
}

TEST_F(OdometryPoseTest, the_newest_localisation_stands_in_until_it_is_too_old)
{
  localize({1, 0, 0}, 10.0);
  expect_at(odometry({}, 10.4), {1, 0, 0});
  EXPECT_TRUE(
      says(rejection(odometry({}, 10.6)), "is 0.6 s older than odom, expected at most transform_tolerance = 0.5"));
}

TEST_F(OdometryPoseTest, a_localisation_that_dates_ahead_will_do_from_the_first_one_on)
{
  localize({1, 0, 0}, 10.1);
  expect_at(odometry({}, 10.0), {1, 0, 0});
}

TEST_F(OdometryPoseTest, a_stamp_of_no_sense_is_refused_like_an_old_one)
{
  localize({1, 0, 0}, 10.0);
  nav_msgs::Odometry message = odometry({}, 10.0);
  message.header.stamp = ros::Time(4294967295u, 999999999u);
  EXPECT_TRUE(says(rejection(message), "older than odom"));
}

TEST_F(OdometryPoseTest, without_localisation_there_is_no_pose)
{
  EXPECT_TRUE(says(rejection(odometry({}, 10.0)), "no transform from 'odom' to 'map'"));
}

TEST_F(OdometryPoseTest, odometry_that_makes_no_sense_is_refused)
{
  localize({}, 0.0, true);
  nav_msgs::Odometry message = odometry({}, 1.0);
  message.child_frame_id = "imu";
  EXPECT_TRUE(says(rejection(message), "child_frame_id is 'imu', expected robot_base_frame = 'base_link'"));
  message = odometry({}, 1.0);
  message.pose.pose.position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(says(rejection(message), "odom: position"));
  message = odometry({}, 1.0);
  message.pose.pose.orientation.w = 0.0;
  EXPECT_TRUE(says(rejection(message), "odom: orientation"));
  message = odometry({}, 1.0);
  message.header.frame_id = "";
  EXPECT_TRUE(says(rejection(message), "odom: header.frame_id is empty"));
}

}  // namespace
}  // namespace fourwis
