#pragma once

#include <string>

#include <nav_msgs/Odometry.h>
#include <tf2/buffer_core.h>

#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// Where the robot is in the global frame when an odometry message says where it is in the odometry's: the
/// localisation's transform between the two at the message's stamp, composed with the message's pose.
class OdometryPose
{
public:
  /// `tf` must outlive this. `transform_tolerance`: how old the localisation's newest transform may be [s].
  OdometryPose(std::string global_frame, std::string robot_base_frame, double transform_tolerance,
               const tf2::BufferCore& tf);

  /// Never waits; where the localisation lags behind the odometry, its newest transform stands in. Throws
  /// ConversionError with a sentence for the user when there is none, or the message makes no sense.
  Pose at(const nav_msgs::Odometry& odometry) const;

private:
  geometry_msgs::TransformStamped lookup(const std::string& odom_frame, const ros::Time& stamp) const;

  const std::string global_frame_, robot_base_frame_;
  const double transform_tolerance_;
  const tf2::BufferCore& tf_;
};

}  // namespace fourwis
