#include "pose_source.h"

#include <tf2/exceptions.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include "conversions.h"
#include "fourwis_navigation/model/sentence.h"
#include "frame_name.h"
#include "stamps.h"

namespace fourwis
{
namespace
{

/// What the robot's pose is called in errors.
constexpr const char* kStartPose = "start pose";

Pose robot_pose(const geometry_msgs::TransformStamped& transform)
{
  return to_pose(transform.transform, "start pose (from tf)", kMaxRobotTilt);
}

}  // namespace

PoseSource::PoseSource(const GlobalPlannerOptions& options, const tf2::BufferCore& tf) : options_(options), tf_(tf) {}

Pose PoseSource::to_global(const geometry_msgs::PoseStamped& pose, const std::string& name) const
{
  return to_pose(in_global(pose, name).pose, name);
}

geometry_msgs::PoseStamped PoseSource::in_global(const geometry_msgs::PoseStamped& pose, const std::string& name) const
{
  const std::string frame = without_slash(pose.header.frame_id);
  if (frame.empty())
    throw ConversionError(name + ": header.frame_id is empty, expected a frame, for example '" + options_.global_frame +
                          "'");
  geometry_msgs::PoseStamped global = pose;
  global.header.frame_id = options_.global_frame;
  if (frame == options_.global_frame)
  {
    to_pose(pose.pose, name);
    return global;
  }
  // Checked before it is transformed, too: tf2 makes a rotation of any four numbers.
  to_pose(pose.pose, name, M_PI);
  tf2::doTransform(pose.pose, global.pose, lookup(frame, name));
  to_pose(global.pose, name + " (from '" + frame + "')");
  return global;
}

Pose PoseSource::robot(const ros::Time& now) const
{
  if (options_.start_from == StartFrom::tf) return robot_from_tf(now);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!initial_)
    throw ConversionError("start pose: none received yet on topic 'initialpose' (start_from is 'initialpose')");
  return *initial_;
}

Pose PoseSource::robot_at(const ros::Time& time, const std::atomic<bool>& cancelled) const
{
  if (options_.start_from == StartFrom::initial_pose || !wait_for_robot(time, cancelled)) return robot(time);
  return robot_pose(lookup(options_.robot_base_frame, kStartPose, time));
}

bool PoseSource::wait_for_robot(const ros::Time& time, const std::atomic<bool>& cancelled) const
{
  // Strictly later: between two transforms the last bit is another one than at the newest, even at the time of one of the two.
  const ros::Time later = time + ros::Duration(0, 1);
  const auto known = [&] { return tf_.canTransform(options_.global_frame, options_.robot_base_frame, later); };
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(options_.transform_tolerance);
  while (!known() && !cancelled && ros::WallTime::now() < end) ros::WallDuration(0.002).sleep();
  return known();
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
  const geometry_msgs::TransformStamped transform = lookup(options_.robot_base_frame, kStartPose);
  const double age = seconds_between(transform.header.stamp, now);
  // A chain of static transforms has no stamp and does not age.
  if (!transform.header.stamp.isZero() && age > options_.transform_tolerance)
    reject<ConversionError>(kStartPose, ": the transform from '", options_.robot_base_frame, "' to '",
                            options_.global_frame, "' is ", age,
                            " s old, expected at most transform_tolerance = ", options_.transform_tolerance, " s");
  return robot_pose(transform);
}

geometry_msgs::TransformStamped PoseSource::lookup(const std::string& frame, const std::string& name,
                                                   const ros::Time& time) const
{
  try
  {
    return tf_.lookupTransform(options_.global_frame, frame, time);
  }
  catch (const tf2::TransformException& error)
  {
    reject<ConversionError>(name, ": no transform from '", frame, "' to '", options_.global_frame, "': ", error.what());
  }
}

}  // namespace fourwis
