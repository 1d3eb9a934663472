#include "fourwis_navigation/ros/drive_conversions.h"

#include <algorithm>
#include <cmath>

#include "refuse.h"

namespace fourwis
{
namespace
{

using PointMessage = fourwis_navigation::TrajectoryPoint;

void check_number(const char* field, double value, const std::string& where)
{
  if (!std::isfinite(value)) refuse(where, ": ", field, " is ", value, ", expected a finite number");
}

Mode drivable_mode(std::uint8_t number, const std::string& where)
{
  const Mode mode = static_cast<Mode>(number);
  if (std::find(kPlannedModes.begin(), kPlannedModes.end(), mode) == kPlannedModes.end())
    refuse(where, ": mode is ", static_cast<int>(number), ", expected 1 (ackermann), 2 (lateral) or 3 (parallel)");
  return mode;
}

TrajectoryPoint to_point(const PointMessage& point, const std::string& where)
{
  check_number("t", point.t, where);
  check_number("x", point.x, where);
  check_number("y", point.y, where);
  check_number("theta", point.theta, where);
  check_number("v", point.v, where);
  check_number("phi", point.phi, where);
  check_number("a", point.a, where);
  check_number("omega", point.omega, where);
  return {point.t, drivable_mode(point.mode, where), point.x, point.y, point.theta, point.v, point.phi, point.a,
          point.omega};
}

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
  for (const PointMessage& point : message.points)
    trajectory.push_back(to_point(point, "trajectory: point " + std::to_string(trajectory.size())));
  return trajectory;
}

WheelCommand to_command(const fourwis_navigation::WheelCommands& message)
{
  WheelCommand command;
  command.sequence = message.sequence;
  if (message.mode == PointMessage::NONE) return command;
  command.mode = drivable_mode(message.mode, "wheel_commands");
  for (const double angle : message.steering_angle) check_number("steering_angle", angle, "wheel_commands");
  for (const double speed : message.drive_speed) check_number("drive_speed", speed, "wheel_commands");
  command.motion = {per_wheel(message.steering_angle), per_wheel(message.drive_speed)};
  return command;
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
