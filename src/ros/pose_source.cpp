#include "fourwis_navigation/ros/pose_source.h"

#include <sstream>

#include <tf2/exceptions.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include "fourwis_navigation/ros/conversions.h"

namespace fourwis
{
namespace
{

/// tf2 knows frames without the leading slash that older tools still write.
std::string without_slash(const std::string& frame)
{
  return frame.compare(0, 1, "/") == 0 ? frame.substr(1) : frame;
}

}  // namespace

PoseSource::PoseSource(const GlobalPlannerOptions& options, const tf2::BufferCore& tf) : options_(options), tf_(tf) {}

Pose PoseSource::to_global(const geometry_msgs::PoseStamped& pose, const std::string& name) const
{
  const std::string frame = without_slash(pose.header.frame_id);
  if (frame.empty())
    throw ConversionError(name + ": header.frame_id is empty, expected a frame, for example '" +
                          options_.global_frame + "'");
  if (frame == options_.global_frame) return to_pose(pose.pose, name);

  // Checked before it is transformed, too: tf2 makes a rotation of any four numbers.
  to_pose(pose.pose, name, M_PI);
  geometry_msgs::Pose transformed;
  tf2::doTransform(pose.pose, transformed, lookup(frame, name));
  return to_pose(transformed, name + " (from '" + frame + "')");
}

Pose PoseSource::robot(const ros::Time& now) const
{
  if (options_.start_from == StartFrom::tf) return robot_from_tf(now);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!initial_)
    throw ConversionError("start pose: none received yet on topic 'initialpose' (start_from is 'initialpose')");
  return *initial_;
}

void PoseSource::set_initial(const geometry_msgs::PoseWithCovarianceStamped& pose)
{
  geometry_msgs::PoseStamped stamped;
  stamped.header = pose.header;
  stamped.pose = pose.pose.pose;
  const Pose initial = to_global(stamped, "initialpose");
  const std::lock_guard<std::mutex> lock(mutex_);
  initial_ = initial;
}

Pose PoseSource::robot_from_tf(const ros::Time& now) const
{
  const geometry_msgs::TransformStamped transform = lookup(options_.robot_base_frame, "start pose");
  const ros::Duration age = now - transform.header.stamp;
  // A chain of static transforms has no stamp and does not age.
  if (!transform.header.stamp.isZero() && age.toSec() > options_.transform_tolerance)
  {
    std::ostringstream text;
    text << "start pose: the transform from '" << options_.robot_base_frame << "' to '" << options_.global_frame
         << "' is " << age.toSec() << " s old, expected at most transform_tolerance = " << options_.transform_tolerance
         << " s";
    throw ConversionError(text.str());
  }
  return to_pose(transform.transform, "start pose (from tf)", kMaxRobotTilt);
}

geometry_msgs::TransformStamped PoseSource::lookup(const std::string& frame, const std::string& name) const
{
  try
  {
    return tf_.lookupTransform(options_.global_frame, frame, ros::Time(0));
  }
  catch (const tf2::TransformException& error)
  {
    throw ConversionError(name + ": no transform from '" + frame + "' to '" + options_.global_frame +
                          "': " + error.what());
  }
}

}  // namespace fourwis
