#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <string>

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <tf2/buffer_core.h>

#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/parameters/node_parameters.h"

namespace fourwis
{

/// Poses in the global frame: the robot's, and those that goals and requests name. What tf does not know is rejected. Safe to use from several threads at once. All functions throw ConversionError with a sentence for the user.
class PoseSource
{
public:
  /// `tf` must outlive this.
  PoseSource(const GlobalPlannerOptions& options, const tf2::BufferCore& tf);

  /// `name` is what the pose is called in errors. A pose in another frame goes through the newest transform and not
  /// that of its own stamp, as move_base does.
  Pose to_global(const geometry_msgs::PoseStamped& pose, const std::string& name) const;
  /// The same as a message, which to_global() turns into the same pose to the last bit.
  geometry_msgs::PoseStamped in_global(const geometry_msgs::PoseStamped& pose, const std::string& name) const;

  /// Where the robot is: from tf and at most `transform_tolerance` old at `now`, or the last initial pose.
  Pose robot(const ros::Time& now) const;

  /// Where the robot was at `time`: waits up to `transform_tolerance` until tf knows, then does with robot(). The last
  /// initial pose knows no time.
  Pose robot_at(const ros::Time& time, const std::atomic<bool>& cancelled) const;

  /// A refused pose leaves the one before in place.
  void set_initial(const geometry_msgs::PoseWithCovarianceStamped& pose);

private:
  Pose robot_from_tf(const ros::Time& now) const;
  bool wait_for_robot(const ros::Time& time, const std::atomic<bool>& cancelled) const;
  /// The transform that takes poses in `frame` to the global frame at `time`; zero: the newest.
  geometry_msgs::TransformStamped lookup(const std::string& frame, const std::string& name,
                                         const ros::Time& time = ros::Time(0)) const;

  const GlobalPlannerOptions options_;
  const tf2::BufferCore& tf_;
  mutable std::mutex mutex_;
  std::optional<Pose> initial_;
};

}  // namespace fourwis
