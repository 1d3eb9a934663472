#pragma once

#include <functional>
#include <string>

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <tf2_ros/transform_broadcaster.h>

#include "fourwis_navigation/parameters/node_parameters.h"

namespace fourwis
{

/// Knows where the simulated robot really is: publishes `~pose` and, in place of a localisation, the transform that
/// makes up for the odometry's errors, dated ahead as amcl does. `initialpose` puts the robot elsewhere.
class IdealLocalization
{
public:
  /// `place` puts the robot elsewhere.
  IdealLocalization(const BaseSimulatorNodeOptions& options, std::function<void(const Pose&)> place);

  /// Publishes where the robot really is at `stamp`.
  void publish(const ros::Time& stamp, const Pose& truth);
  /// Publishes the transform: at `stamp` the robot is at `truth`, and odometry has it at `odometry`.
  void correct(const ros::Time& stamp, const Pose& truth, const Pose& odometry);

  /// Without the transform until further notice.
  void set_lost(bool lost) { lost_ = lost; }

private:
  void on_initial_pose(const geometry_msgs::PoseWithCovarianceStamped& message);

  const std::string global_frame_, odom_frame_;
  const ros::Duration ahead_;
  const std::function<void(const Pose&)> place_;
  bool lost_ = false;
  ros::NodeHandle node_;
  ros::Publisher pose_;
  ros::Subscriber initial_pose_;
  tf2_ros::TransformBroadcaster tf_;
};

}  // namespace fourwis
