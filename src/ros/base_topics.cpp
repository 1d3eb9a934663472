#include "base_topics.h"

#include "drive_conversions.h"
#include "fourwis_navigation/WheelStates.h"
#include "fourwis_navigation/model/sentence.h"

namespace fourwis
{
namespace
{

/// Names of the joints in urdf/fourwis.urdf, in wheel order.
constexpr const char* kWheelNames[kWheels] = {"front_left", "front_right", "rear_left", "rear_right"};

/// Variance of what a planar base says about z, roll and pitch: they are zero.
constexpr double kPlanar = 1e-6;

boost::array<double, 36> to_covariance(const Eigen::Matrix3d& planar)
{
  constexpr std::size_t rows[3] = {0, 1, 5};
  boost::array<double, 36> covariance{};
  for (const std::size_t other : {2u, 3u, 4u}) covariance[other * 7] = kPlanar;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) covariance[rows[row] * 6 + rows[column]] = planar(row, column);
  return covariance;
}

}  // namespace

nav_msgs::Odometry to_message(const Odometry& odometry, const ros::Time& stamp, const BaseFrames& frames)
{
  nav_msgs::Odometry message;
  message.header.stamp = stamp;
  message.header.frame_id = frames.odom_frame;
  message.child_frame_id = frames.robot_base_frame;
  message.pose.pose = to_message(odometry.pose);
  message.pose.covariance = to_covariance(odometry.pose_covariance);
  message.twist.twist = to_message(odometry.motion.twist);
  message.twist.covariance = to_covariance(odometry.motion.covariance);
  return message;
}

BaseTopics::BaseTopics(const Robot& robot, const BaseFrames& frames)
  : frames_(frames),
    base_link_(robot),
    odometry_(robot, {})
{
  set_odometry({});
  ros::NodeHandle node;
  wheel_states_ = node.advertise<fourwis_navigation::WheelStates>("wheel_states", 10);
  odom_ = node.advertise<nav_msgs::Odometry>("odom", 10);
  joint_states_ = node.advertise<sensor_msgs::JointState>("joint_states", 10);
  for (const char* kind : {"steering", "wheel"})
    for (const char* name : kWheelNames) joints_.name.push_back(joined(name, '_', kind, "_joint"));
  joints_.position.assign(joints_.name.size(), 0.0);
}

void BaseTopics::publish(const ros::Time& stamp, const WheelState& state, const std::string& explanation)
{
  odometry_.update(state.stamp, state.motion);
  if (!silent_.odom) publish_odometry(stamp);
  if (!silent_.wheel_states) wheel_states_.publish(to_message(state, stamp, explanation));
  publish_joints(stamp, state);
}

void BaseTopics::publish_odometry(const ros::Time& stamp)
{
  const nav_msgs::Odometry odom = to_message(base_link_.from_centre(odometry_.state()), stamp, frames_);
  odom_.publish(odom);
  if (frames_.publish_odom_tf) tf_.sendTransform(to_message(odometry(), odom.header, frames_.robot_base_frame));
}

void BaseTopics::publish_joints(const ros::Time& stamp, const WheelState& state)
{
  if (state.stamp <= rolled_until_) return;  // nothing new has been measured
  const double elapsed = joints_.header.stamp.isZero() ? 0.0 : state.stamp - rolled_until_;
  joints_.header.stamp = stamp;
  rolled_until_ = state.stamp;
  for (std::size_t i = 0; i < state.motion.angle.size(); ++i)
  {
    joints_.position[i] = state.motion.angle[i];
    joints_.position[kWheels + i] += state.motion.speed[i] * elapsed / frames_.wheel_radius;
  }
  joint_states_.publish(joints_);
}

}  // namespace fourwis
