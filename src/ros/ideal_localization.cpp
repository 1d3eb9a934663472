#include "ideal_localization.h"

#include "conversions.h"
#include "fourwis_navigation/model/sentence.h"

#include <utility>

#include <geometry_msgs/PoseStamped.h>
#include <ros/console.h>

namespace fourwis
{

IdealLocalization::IdealLocalization(const BaseSimulatorNodeOptions& options, std::function<void(const Pose&)> place)
  : global_frame_(options.global_frame),
    odom_frame_(options.frames.odom_frame),
    ahead_(options.transform_tolerance),
    place_(std::move(place))
{
  pose_ = ros::NodeHandle("~").advertise<geometry_msgs::PoseStamped>("pose", 10);
  initial_pose_ = node_.subscribe<geometry_msgs::PoseWithCovarianceStamped>(
      "initialpose", 10,
      [this](const geometry_msgs::PoseWithCovarianceStampedConstPtr& message) { on_initial_pose(*message); });
}

void IdealLocalization::publish(const ros::Time& stamp, const Pose& truth)
{
  geometry_msgs::PoseStamped message;
  message.header.stamp = stamp;
  message.header.frame_id = global_frame_;
  message.pose = to_message(truth);
  pose_.publish(message);
}

void IdealLocalization::correct(const ros::Time& stamp, const Pose& truth, const Pose& odometry)
{
  if (lost_) return;
  std_msgs::Header dated_ahead;
  dated_ahead.stamp = stamp + ahead_;
  dated_ahead.frame_id = global_frame_;
  const Pose map_to_odom = compose(truth, relative_to(odometry, {}));
  tf_.sendTransform(to_message(map_to_odom, dated_ahead, odom_frame_));
}

void IdealLocalization::on_initial_pose(const geometry_msgs::PoseWithCovarianceStamped& message)
{
  try
  {
    if (message.header.frame_id != global_frame_)
      reject<ConversionError>("initialpose: header.frame_id is '", message.header.frame_id,
                              "', expected global_frame = '", global_frame_, "'");
    place_(to_pose(message.pose.pose, "initialpose"));
  }
  catch (const ConversionError& error)
  {
    ROS_WARN("%s", error.what());
  }
}

}  // namespace fourwis
