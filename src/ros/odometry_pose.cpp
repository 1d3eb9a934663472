#include "odometry_pose.h"

#include <cmath>

#include <tf2/exceptions.h>

#include "conversions.h"
#include "fourwis_navigation/model/sentence.h"
#include "stamps.h"

namespace fourwis
{

OdometryPose::OdometryPose(std::string global_frame, std::string robot_base_frame, double transform_tolerance,
                           const tf2::BufferCore& tf)
  : global_frame_(std::move(global_frame)),
    robot_base_frame_(std::move(robot_base_frame)),
    transform_tolerance_(transform_tolerance),
    tf_(tf)
{}

Pose OdometryPose::at(const nav_msgs::Odometry& odometry) const
{
  if (odometry.child_frame_id != robot_base_frame_)
    reject<ConversionError>("odom: child_frame_id is '", odometry.child_frame_id, "', expected robot_base_frame = '",
                            robot_base_frame_, "'");
  if (odometry.header.frame_id.empty())
    reject<ConversionError>("odom: header.frame_id is empty, expected the name of a tf frame");
  const Pose in_odom = to_pose(odometry.pose.pose, "odom", kMaxRobotTilt);
  const auto localization = lookup(odometry.header.frame_id, odometry.header.stamp);
  return compose(to_pose(localization.transform, "tf of odom", kMaxRobotTilt), in_odom);
}

geometry_msgs::TransformStamped OdometryPose::lookup(const std::string& odom_frame, const ros::Time& stamp) const
{
  try
  {
    if (tf_.canTransform(global_frame_, odom_frame, stamp))
      return tf_.lookupTransform(global_frame_, odom_frame, stamp);
    geometry_msgs::TransformStamped newest = tf_.lookupTransform(global_frame_, odom_frame, ros::Time(0));
    const double age = seconds_between(newest.header.stamp, stamp);
    if (std::abs(age) <= transform_tolerance_) return newest;
    reject<ConversionError>("tf: the transform from '", odom_frame, "' to '", global_frame_, "' is ", age,
                            " s older than odom, expected at most transform_tolerance = ", transform_tolerance_, " s");
  }
  catch (const tf2::TransformException& error)
  {
    reject<ConversionError>("tf: no transform from '", odom_frame, "' to '", global_frame_, "': ", error.what());
  }
}

}  // namespace fourwis
