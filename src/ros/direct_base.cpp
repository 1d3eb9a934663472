#include "direct_base.h"

#include <ros/console.h>

#include "drive_conversions.h"
#include "stamps.h"

namespace fourwis
{
namespace
{

/// Time does not wait for a controller that has been silent for longer.
const ros::WallDuration kPatience(1.0);

const char* explain(BaseState state)
{
  switch (state)
  {
    case BaseState::not_ready: return "not ready";
    case BaseState::ready: return "not enabled";
    case BaseState::enabled: return "";
    case BaseState::stopping: return "stopping: commands do not come any more";
    case BaseState::fault: return "fault: the wheels did not align in time";
  }
  return "";
}

}  // namespace

DirectBase::DirectBase(const BaseSimulatorParameters& parameters, BaseSimulator& simulator)
  : lockstep_period_(parameters.node.lockstep_period),
    simulator_(simulator),
    topics_(parameters.robot, parameters.node.frames)
{
  wheel_commands_ = node_.subscribe<fourwis_navigation::WheelCommands>(
      "wheel_commands", 10, [this](const fourwis_navigation::WheelCommandsConstPtr& message) { on_command(*message); },
      nullptr, ros::TransportHints().tcpNoDelay());
}

void DirectBase::publish(const ros::Time& stamp)
{
  const WheelState state = simulator_.wheels();
  topics_.publish(stamp, state, explain(state.state));
}

bool DirectBase::answered(const ros::Time& now) const
{
  if (lockstep_period_ == 0.0 || ros::WallTime::now() - heard_ > kPatience) return true;
  return seconds_between(commanded_, now) < lockstep_period_;
}

void DirectBase::on_command(const fourwis_navigation::WheelCommands& message)
{
  commanded_ = message.header.stamp;
  heard_ = ros::WallTime::now();
  if (simulator_.command(to_command(message))) return;
  ROS_WARN_THROTTLE(1.0, "wheel_commands: mode %d or one of the numbers is unusable, stopping", message.mode);
  simulator_.command({});
}

}  // namespace fourwis
