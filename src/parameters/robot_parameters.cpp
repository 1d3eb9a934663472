#include <string>

#include "parameter_table.h"

namespace fourwis
{
namespace
{

template <class Value>
auto robot(Value Robot::*member)
{
  return [member](Robot& robot) -> Slot { return &(robot.*member); };
}

const ParameterTable<Robot>& robot_table()
{
  static const ParameterTable<Robot> table = {
      {"length", robot(&Robot::length), 0.05, 20.0, "m"},
      {"width", robot(&Robot::width), 0.05, 20.0, "m"},
      {"wheelbase", robot(&Robot::wheelbase), 0.01, 20.0, "m"},
      {"track_width", robot(&Robot::track_width), 0.01, 20.0, "m"},
      {"max_steering_angle", robot(&Robot::max_steering_angle), 0.01, M_PI * 80 / 180, "rad"},
      {"max_steering_rate", robot(&Robot::max_steering_rate), 0.01, 100.0, "rad/s"},
      {"max_speed", robot(&Robot::max_speed), 0.01, 20.0, "m/s"},
      {"max_acceleration", robot(&Robot::max_acceleration), 0.01, 50.0, "m/s^2"},
      {"mode_switch_time", robot(&Robot::mode_switch_time), 0.0, 60.0, "s"},
      {"wheel_max_angle", robot(&Robot::wheel_max_angle), 0.01, 10.0, "rad"},
      {"wheel_max_rate", robot(&Robot::wheel_max_rate), 0.01, 100.0, "rad/s"},
      {"wheel_max_speed", robot(&Robot::wheel_max_speed), 0.01, 50.0, "m/s"},
      {"safety_margin", robot(&Robot::safety_margin), 0.0, 1.0, "m"},
  };
  return table;
}

/// A wheel outside the rectangle length x width would be invisible to every collision check.
void check_axis_inside(const char* axis, double distance, const char* side, double extent)
{
  if (distance <= extent) return;
  throw ConfigError("parameter '" + std::string(axis) + "' is " + std::to_string(distance) + ", expected at most '" +
                    side + "' (" + std::to_string(extent) + " m): the wheels must lie within the body's rectangle");
}

}  // namespace

Robot robot_from(const ParameterMap& parameters)
{
  const Robot robot = options_from(robot_table(), parameters);
  check_axis_inside("wheelbase", robot.wheelbase, "length", robot.length);
  check_axis_inside("track_width", robot.track_width, "width", robot.width);
  return robot;
}

}  // namespace fourwis
