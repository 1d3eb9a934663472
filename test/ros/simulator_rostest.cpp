#include <limits>

#include <nav_msgs/Odometry.h>
#include <sensor_msgs/JointState.h>

#include "drive_fixture.h"
#include "fourwis_navigation/WheelCommands.h"

namespace fourwis
{
namespace
{

using fourwis_navigation::TrajectoryPoint;
using fourwis_navigation::WheelCommands;

/// The base receives commands of the test's own.
class Simulator : public DriveFixture
{
protected:
  void SetUp() override
  {
    DriveFixture::SetUp();
    ASSERT_TRUE(wait_until([this] { return commands_.getNumSubscribers() > 0 && wheel_states_.connected(); }));
    forget();
  }

  /// Straight ahead, as a controller would say it again and again, until the base does.
  void drive_ahead(double speed)
  {
    ASSERT_TRUE(wait_until([&] {
      command(TrajectoryPoint::ACKERMANN, speed);
      const auto states = wheel_states_.messages();
      return !states.empty() && std::abs(states.back()->drive_speed[0] - speed) < 0.01;
    }));
  }

  void command(std::uint8_t mode, double speed)
  {
    WheelCommands message;
    message.header.stamp = ros::Time::now();
    message.mode = mode;
    message.sequence = ++sequence_;
    message.drive_speed.assign(speed);
    commands_.publish(message);
  }

  std::uint32_t sequence_ = 0;
  ros::Publisher commands_ = ros::NodeHandle().advertise<WheelCommands>("wheel_commands", 10);
};

TEST_F(Simulator, wheel_states_and_odometry_come_in_pairs_of_one_stamp)
{
  Inbox<nav_msgs::Odometry> odometry("odom");
  const auto first = odometry.wait_for_any();
  ASSERT_TRUE(first);
  for (int i = 0; i < 20; ++i)
  {
    const ros::Time stamp = first->header.stamp + ros::Duration(0.01 * i);
    EXPECT_TRUE(odometry.wait_for([&](const nav_msgs::Odometry& o) { return o.header.stamp == stamp; }));
    EXPECT_TRUE(wheel_states_.wait_for([&](const WheelStates& w) { return w.header.stamp == stamp; }));
  }
  EXPECT_EQ(first->header.frame_id, "odom");
  EXPECT_EQ(first->child_frame_id, "base_link");
}

TEST_F(Simulator, drives_as_it_is_told_and_says_so_in_odometry_joints_and_truth)
{
  Inbox<nav_msgs::Odometry> odometry("odom");
  Inbox<sensor_msgs::JointState> joints("joint_states");
  drive_ahead(0.5);
  const auto drives = [](const nav_msgs::Odometry& o) {
    return std::abs(o.twist.twist.linear.x - 0.5) < 0.02 && o.twist.covariance[0] > 0.0;
  };
  EXPECT_TRUE(odometry.wait_for(drives));
  EXPECT_TRUE(wait_until([this] { return truth().x > kMiddle.x + 0.05; }));
  const auto turned = joints.wait_for([](const sensor_msgs::JointState& j) { return j.position.at(4) > 0.1; });
  ASSERT_TRUE(turned);
  EXPECT_EQ(turned->name.at(0), "front_left_steering_joint");
  EXPECT_EQ(turned->name.at(4), "front_left_wheel_joint");
}

TEST_F(Simulator, stops_when_commands_cease)
{
  drive_ahead(0.5);
  wait_for_rest();
  const auto says_so = [](const WheelStates& w) { return w.state == WheelStates::STOPPING && !w.message.empty(); };
  EXPECT_TRUE(wheel_states_.wait_for(says_so));
}

TEST_F(Simulator, takes_a_command_that_makes_no_sense_for_a_stop)
{
  drive_ahead(0.5);
  command(TrajectoryPoint::ACKERMANN, std::numeric_limits<double>::quiet_NaN());
  ASSERT_TRUE(wheel_states_.wait_for([](const WheelStates& w) { return w.mode == TrajectoryPoint::NONE; }));
  wait_for_rest();
}

TEST_F(Simulator, an_initial_pose_in_another_frame_or_of_no_sense_is_ignored)
{
  geometry_msgs::PoseWithCovarianceStamped elsewhere;
  elsewhere.header.frame_id = "odom";
  elsewhere.pose.pose = to_message(Pose{1, 1, 0});
  place_.publish(elsewhere);
  elsewhere.header.frame_id = "map";
  elsewhere.pose.pose.orientation.w = 5.0;
  place_.publish(elsewhere);
  pass(0.3);
  EXPECT_LT(distance(truth(), kMiddle), 1e-6);
  place({12, 11, 1.0});
  EXPECT_LT(distance(truth(), {12, 11, 1.0}), 1e-6);
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "test_simulator");
}
