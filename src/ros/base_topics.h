#pragma once

#include <string>

#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <sensor_msgs/JointState.h>
#include <tf2_ros/transform_broadcaster.h>

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/parameters/node_parameters.h"
#include "fourwis_navigation/vehicle/base_link.h"
#include "fourwis_navigation/vehicle/wheel_odometry.h"

namespace fourwis
{

/// Everything that a base says of itself, computed from what its wheels do: `wheel_states`, `odom` of the same stamp
/// with covariances, the transform of the robot in the odom frame, and `joint_states` for the robot's model.
class BaseTopics
{
public:
  BaseTopics(const Robot& robot, const BaseFrames& frames);

  /// Odometry goes on to the state's own stamp, whose clock must be a steady one, and everything is published under
  /// `stamp`, whose clock may be set. `explanation`: what is the matter with the base.
  void publish(const ros::Time& stamp, const WheelState& state, const std::string& explanation);

  /// From now on odometry has the robot there. Poses are those of base_link, which begins at the origin of the odom frame.
  void set_odometry(const Pose& pose) { odometry_.set_pose(base_link_.to_centre(pose)); }
  Pose odometry() const { return base_link_.from_centre(odometry_.state().pose); }

  /// What is not published until further notice; for simulations of a broken base.
  struct Silence
  {
    bool odom = false;  ///< neither topic nor transform
    bool wheel_states = false;
  };
  void set_silence(const Silence& silent) { silent_ = silent; }

private:
  void publish_odometry(const ros::Time& stamp);
  void publish_joints(const ros::Time& stamp, const WheelState& state);

  const BaseFrames frames_;
  const BaseLink base_link_;
  WheelOdometry odometry_;
  Silence silent_;
  sensor_msgs::JointState joints_;  ///< as published last: rolled angles add up
  double rolled_until_ = 0.0;       ///< stamp of the state behind them [s]
  ros::Publisher wheel_states_, odom_, joint_states_;
  tf2_ros::TransformBroadcaster tf_;
};

/// Odometry of base_link as a message, covariances of the planar state in the rows and columns of x, y and yaw.
nav_msgs::Odometry to_message(const Odometry& odometry, const ros::Time& stamp, const BaseFrames& frames);

}  // namespace fourwis
