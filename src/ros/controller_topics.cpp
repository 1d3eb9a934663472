#include "controller_topics.h"

#include <cmath>

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Path.h>
#include <ros/console.h>
#include <ros/single_subscriber_publisher.h>

#include "drive_conversions.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "stamps.h"
#include "tracking_marker.h"

namespace fourwis
{
namespace
{

using fourwis_navigation::Tracking;

/// Between two messages of prediction and marker, which only rviz shows [s].
constexpr double kPicturePeriod = 0.1;

}  // namespace

Tracking to_message(const ControlStep& step, const std::string& frame)
{
  const TrackOutput& output = step.output;
  Tracking message;
  message.header.stamp = step.stamp;
  message.header.frame_id = frame;
  message.state = static_cast<std::uint8_t>(output.state);
  message.message = std::string(output.message);
  if (!message.message.empty() && !step.problem.empty()) message.message += ": " + step.problem;
  message.trajectory = step.trajectory;
  message.enabled = step.enabled;
  message.t = output.t;
  message.lateral_error = output.lateral_error;
  message.longitudinal_error = output.longitudinal_error;
  message.heading_error = output.heading_error;
  message.speed = step.speed;
  message.solve_ms = step.solve_ms;
  return message;
}

ControllerTopics::ControllerTopics(const Robot& robot, const MpcControllerOptions& options, const ListenerLeft& left)
  : robot_(robot),
    base_link_(robot),
    global_frame_(options.global_frame),
    robot_base_frame_(options.robot_base_frame)
{
  ros::NodeHandle node, private_node("~");
  wheel_commands_ = node.advertise<fourwis_navigation::WheelCommands>("wheel_commands", 1);
  cmd_vel_ = node.advertise<geometry_msgs::Twist>("cmd_vel", 1);
  tracking_ = private_node.advertise<Tracking>(
      "tracking", 100, ros::SubscriberStatusCallback(),
      [left](const ros::SingleSubscriberPublisher& listener) { left(listener.getSubscriberName()); });
  marker_ = private_node.advertise<visualization_msgs::Marker>("marker", 1);
  predicted_path_ = private_node.advertise<nav_msgs::Path>("predicted_path", 1);
}

void ControllerTopics::publish(const ControlStep& step, const Tracking& tracking, const std::vector<Pose>& prediction)
{
  const TrackOutput& output = step.output;
  wheel_commands_.publish(to_message(output.command, step.stamp));
  cmd_vel_.publish(
      to_message(base_link_.from_centre(body_twist(robot_, output.command.mode, output.speed, output.phi))));
  tracking_.publish(tracking);
  if (std::abs(seconds_between(shown_, step.stamp)) < kPicturePeriod) return;
  shown_ = step.stamp;
  marker_.publish(tracking_marker(tracking, robot_base_frame_));
  publish_prediction(step.stamp, prediction);
}

void ControllerTopics::publish_refusal(const ros::Time& trajectory, const std::string& message)
{
  ROS_WARN("%s", message.c_str());
  publish_tracking(Tracking::REFUSED, trajectory, message);
}

void ControllerTopics::publish_without_measurement(const std::string& message)
{
  publish_tracking(Tracking::STOPPING, {}, message);
}

void ControllerTopics::publish_tracking(std::uint8_t state, const ros::Time& trajectory, const std::string& message)
{
  Tracking tracking;
  tracking.header.stamp = ros::Time::now();
  tracking.header.frame_id = global_frame_;
  tracking.state = state;
  tracking.message = message;
  tracking.trajectory = trajectory;
  tracking_.publish(tracking);
}

void ControllerTopics::publish_prediction(const ros::Time& stamp, const std::vector<Pose>& prediction)
{
  nav_msgs::Path path;
  path.header.stamp = stamp;
  path.header.frame_id = global_frame_;
  for (const Pose& pose : prediction)
  {
    geometry_msgs::PoseStamped& place = path.poses.emplace_back();
    place.header = path.header;
    place.pose = to_message(base_link_.from_centre(pose));
  }
  predicted_path_.publish(path);
}

}  // namespace fourwis
