#include "drive_conversions.h"

#include <algorithm>

namespace fourwis
{
namespace
{

template <class Array>
PerWheel per_wheel(const Array& values)
{
  PerWheel wheels{};
  std::copy(values.begin(), values.end(), wheels.begin());
  return wheels;
}

template <class Message>
void set_motion(const WheelMotion& motion, Message& message)
{
  std::copy(motion.angle.begin(), motion.angle.end(), message.steering_angle.begin());
  std::copy(motion.speed.begin(), motion.speed.end(), message.drive_speed.begin());
}

}  // namespace

Trajectory to_trajectory(const fourwis_navigation::ModeTrajectory& message)
{
  Trajectory trajectory;
  trajectory.reserve(message.points.size());
  for (const fourwis_navigation::TrajectoryPoint& point : message.points)
    trajectory.push_back({point.t, static_cast<Mode>(point.mode), point.x, point.y, point.theta, point.v, point.phi,
                          point.a, point.omega});
  return trajectory;
}

WheelCommand to_command(const fourwis_navigation::WheelCommands& message)
{
  return {static_cast<Mode>(message.mode),
          message.sequence,
          {per_wheel(message.steering_angle), per_wheel(message.drive_speed)}};
}

WheelState to_wheel_state(const fourwis_navigation::WheelStates& message)
{
  WheelState state;
  state.stamp = message.header.stamp.toSec();
  state.state = message.state <= fourwis_navigation::WheelStates::FAULT ? static_cast<BaseState>(message.state)
                                                                        : BaseState::fault;
  state.mode = static_cast<Mode>(message.mode);
  state.sequence = message.sequence;
  state.motion = {per_wheel(message.steering_angle), per_wheel(message.drive_speed)};
  state.aligned = message.aligned != 0;
  return state;
}

fourwis_navigation::WheelCommands to_message(const WheelCommand& command, const ros::Time& stamp)
{
  fourwis_navigation::WheelCommands message;
  message.header.stamp = stamp;
  message.mode = static_cast<std::uint8_t>(command.mode);
  message.sequence = command.sequence;
  set_motion(command.motion, message);
  return message;
}

fourwis_navigation::WheelStates to_message(const WheelState& state, const ros::Time& stamp,
                                           const std::string& explanation)
{
  fourwis_navigation::WheelStates message;
  message.header.stamp = stamp;
  message.state = static_cast<std::uint8_t>(state.state);
  message.message = explanation;
  message.mode = static_cast<std::uint8_t>(state.mode);
  message.sequence = state.sequence;
  set_motion(state.motion, message);
  message.aligned = state.aligned;
  return message;
}

}  // namespace fourwis
