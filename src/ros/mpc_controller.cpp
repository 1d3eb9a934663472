#include "fourwis_navigation/ros/mpc_controller.h"

namespace fourwis
{
namespace
{

/// How many odometry messages may wait for their wheel states, and the other way round.
constexpr std::uint32_t kPairQueue = 20;

}  // namespace

MpcController::MpcController(const MpcControllerParameters& parameters)
  : tf_listener_(tf_, node_, false),
    topics_(parameters.robot, parameters.node),
    loop_(parameters, tf_,
          [this](const ros::Time& trajectory, const std::string& message)
          {
            topics_.publish_refusal(trajectory, message);
            diagnostics_.refused(message);
          }),
    odom_(node_, "odom", kPairQueue, ros::TransportHints().tcpNoDelay()),
    wheel_states_(node_, "wheel_states", kPairQueue, ros::TransportHints().tcpNoDelay()),
    pairs_(odom_, wheel_states_, kPairQueue)
{
  trajectory_ = node_.subscribe<fourwis_navigation::ModeTrajectory>(
    "trajectory", 10,
    [this](const fourwis_navigation::ModeTrajectoryConstPtr& trajectory) { loop_.take(*trajectory); });
  pairs_.registerCallback(&MpcController::on_pair, this);
  watchdog_ = node_.createTimer(ros::Duration(1.0 / parameters.track.controller_frequency),
                                [this](const ros::TimerEvent& event) { publish(loop_.watch(event.current_real)); });
}

void MpcController::on_pair(const nav_msgs::OdometryConstPtr& odometry,
                            const fourwis_navigation::WheelStatesConstPtr& wheels)
{
  publish(loop_.measured(*odometry, *wheels));
}

void MpcController::publish(const std::optional<ControlStep>& step)
{
  if (!step) return;
  topics_.publish(*step, loop_.prediction());
  diagnostics_.stepped(*step);
}

}  // namespace fourwis
