#pragma once

#include <message_filters/subscriber.h>
#include <message_filters/time_synchronizer.h>
#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <ros/timer.h>
#include <tf2/buffer_core.h>
#include <tf2_ros/transform_listener.h>

#include "control_loop.h"
#include "controller_diagnostics.h"
#include "controller_topics.h"

namespace fourwis
{

/// The controller's node: drives the robot along the trajectories that come on `trajectory`, as long as their sender is
/// there and listens to the answers. README.md describes its topics. All callbacks, also those of tf, are on the global
/// queue: spin it with one thread.
class MpcController
{
public:
  explicit MpcController(const MpcControllerParameters& parameters);

private:
  void on_permit(const fourwis_navigation::DrivePermitConstPtr& permit) { loop_.take_permit(*permit); }
  void on_trajectory(const ros::MessageEvent<const fourwis_navigation::ModeTrajectory>& trajectory);
  /// Stops when it was this node that sent what is driven. A sender that never listened is not missed.
  void on_listener_left(const std::string& node);
  void on_odometry(const nav_msgs::OdometryConstPtr& odometry);
  void on_wheel_states(const fourwis_navigation::WheelStatesConstPtr& wheels);
  void on_pair(const nav_msgs::OdometryConstPtr& odometry, const fourwis_navigation::WheelStatesConstPtr& wheels);
  void watch(const ros::Time& now);
  void publish(const std::optional<ControlStep>& step);

  const std::string global_frame_;
  std::string sender_;  ///< of the trajectory that was taken last
  ros::NodeHandle node_;
  tf2::BufferCore tf_;
  tf2_ros::TransformListener tf_listener_;
  ControllerTopics topics_;
  ControllerDiagnostics diagnostics_;
  ControlLoop loop_;
  ros::Subscriber trajectory_, permit_;
  message_filters::Subscriber<nav_msgs::Odometry> odom_;
  message_filters::Subscriber<fourwis_navigation::WheelStates> wheel_states_;
  message_filters::TimeSynchronizer<nav_msgs::Odometry, fourwis_navigation::WheelStates> pairs_;
  ros::Timer watchdog_;
};

}  // namespace fourwis
