#include "mpc_controller.h"

#include <ros/console.h>

namespace fourwis
{
namespace
{

/// How many odometry messages may wait for their wheel states, and the other way round.
constexpr std::uint32_t kPairQueue = 20;

}  // namespace

MpcController::MpcController(const MpcControllerParameters& parameters)
  : global_frame_(parameters.node.global_frame),
    tf_listener_(tf_, node_, false),
    topics_(parameters.robot, parameters.node, [this](const std::string& node) { on_listener_left(node); }),
    diagnostics_(parameters.robot),
    loop_(parameters, tf_,
          [this](const ros::Time& trajectory, const std::string& message) {
            topics_.publish_refusal(trajectory, message);
            diagnostics_.refused(message);
          }),
    odom_(node_, "odom", kPairQueue, ros::TransportHints().tcpNoDelay()),
    wheel_states_(node_, "wheel_states", kPairQueue, ros::TransportHints().tcpNoDelay()),
    pairs_(odom_, wheel_states_, kPairQueue)
{
  trajectory_ = node_.subscribe("trajectory", 10, &MpcController::on_trajectory, this);
  permit_ = node_.subscribe("drive_permit", 1, &MpcController::on_permit, this, ros::TransportHints().tcpNoDelay());
  odom_.registerCallback(&MpcController::on_odometry, this);
  wheel_states_.registerCallback(&MpcController::on_wheel_states, this);
  pairs_.registerCallback(&MpcController::on_pair, this);
  watchdog_ = node_.createTimer(ros::Duration(1.0 / parameters.track.controller_frequency),
                                [this](const ros::TimerEvent& event) { watch(event.current_real); });
}

void MpcController::on_trajectory(const ros::MessageEvent<const fourwis_navigation::ModeTrajectory>& trajectory)
{
  if (loop_.take(*trajectory.getMessage())) sender_ = trajectory.getPublisherName();
}

void MpcController::on_listener_left(const std::string& node)
{
  if (node != sender_) return;
  ROS_WARN("%s, which sent the last trajectory, is gone: stopping", node.c_str());
  loop_.take({});
}

void MpcController::on_odometry(const nav_msgs::OdometryConstPtr& odometry)
{
  loop_.heard_odometry(odometry->header.stamp);
}

void MpcController::on_wheel_states(const fourwis_navigation::WheelStatesConstPtr& wheels)
{
  loop_.heard_wheel_states(wheels->header.stamp);
}

void MpcController::on_pair(const nav_msgs::OdometryConstPtr& odometry,
                            const fourwis_navigation::WheelStatesConstPtr& wheels)
{
  publish(loop_.measured(*odometry, *wheels));
}

void MpcController::watch(const ros::Time& now)
{
  if (!loop_.has_measured())
    return topics_.publish_without_measurement("no odom and wheel_states of one stamp came yet");
  publish(loop_.watch(now));
}

void MpcController::publish(const std::optional<ControlStep>& step)
{
  if (!step) return;
  const fourwis_navigation::Tracking tracking = to_message(*step, global_frame_);
  topics_.publish(*step, tracking, loop_.prediction());
  diagnostics_.stepped(tracking);
}

}  // namespace fourwis
