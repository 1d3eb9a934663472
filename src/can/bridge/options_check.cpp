#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/model/sentence.h"
#include "fourwis_navigation/vehicle/alignment.h"
#include "sdo_script.h"

namespace fourwis::can
{
namespace
{

/// Rounds what is printed with two digits up, so that it is enough.
constexpr double kRoundUp = 0.005;

/// How far the wheels of a Ranger turn to either side, with a reserve for a quarter turn in a few digits [rad].
constexpr double kRangerTravel = M_PI / 2.0 + 1e-4;

void check_nodes(const BridgeOptions& options)
{
  std::set<int> nodes = {options.master_node};
  for (const WheelAxes* axes : {&options.steering, &options.driving})
    for (const AxisOptions& axis : *axes)
      if (!nodes.insert(axis.node).second)
        reject_option("node", std::to_string(axis.node), "one that no other axis has, nor master_node");
}

/// What a drive's 32 bits cannot hold would reach it as something else: angles, speeds (with sign), accelerations.
void check_counts(const Robot& robot, const BridgeOptions& options, const AxisOptions& axis, bool steering)
{
  const double counts = std::abs(scale_of(options, axis, steering).counts_per_unit());
  const Ramps ramps = ramps_of(robot, options, steering);
  const double travel = steering ? robot.wheel_max_angle + std::abs(axis.offset) : 0.0;
  const double greatest = std::max({travel, ramps.speed, 0.5 * ramps.acceleration, 0.5 * ramps.deceleration});
  if (greatest * counts > std::numeric_limits<std::int32_t>::max())
    reject<std::invalid_argument>("node ", axis.node,
                                  " would need more than 32 bits for its angle, speed or acceleration: ", counts,
                                  " counts in a radian or metre are too many");
}

/// Methods that search nothing but declare a zero: every start would declare another one.
void check_homing(const BridgeOptions& options)
{
  const int method = options.homing_method;
  if (options.homing && (method == 0 || method == 35 || method == 37))
    reject_option("homing_method", std::to_string(method), "one that finds the zero of a steering drive");
}

void check_places(const RangerOptions& ranger)
{
  const std::set<int> places(ranger.place.begin(), ranger.place.end());
  if (places.size() < ranger.place.size()) reject<std::invalid_argument>("ranger/place is not each of 1 to 4 once");
}

void check_cycle_time(double cycle_time)
{
  const double milliseconds = cycle_time * 1e3;
  if (std::abs(milliseconds - std::round(milliseconds)) > 1e-6)
    reject_option("cycle_time", to_text(cycle_time), "whole milliseconds, in s");
}

void check_shorter(const char* shorter, double a, const char* longer, double b)
{
  if (!(a < b)) reject<std::invalid_argument>(shorter, " is ", a, " s, expected less than ", longer, " (", b, " s)");
}

/// Heartbeats leave with cycles, and a cycle may be late.
void check_heartbeats(const BridgeOptions& options)
{
  const double cycles = std::ceil(options.heartbeat_period / options.cycle_time - 1e-6);
  check_shorter("heartbeat_period in whole cycles, and one more,", (cycles + 1.0) * options.cycle_time,
                "drive_watchdog", options.drive_watchdog);
  check_shorter("twice heartbeat_period", 2.0 * options.heartbeat_period, "heartbeat_timeout",
                options.heartbeat_timeout);
}

/// The angles of wheels beyond a quarter turn are none that the base can be told.
void check_travel(const Robot& robot, const BridgeOptions& options)
{
  if (options.protocol == Protocol::ranger && robot.wheel_max_angle > kRangerTravel)
    reject_option("wheel_max_angle", to_text(robot.wheel_max_angle),
                  "at most 1.5708 rad where 'protocol' is 'ranger': its wheels turn by 90 deg to either side");
}

/// A stop must end before its timeout switches the drives off.
void check_stop(const Robot& robot, const BridgeOptions& options)
{
  const double duration = robot.wheel_max_speed / options.stop_deceleration + options.standstill_time;
  if (options.stop_timeout < duration)
    reject_option(
        "stop_timeout", to_text(options.stop_timeout),
        sentence("at least %.2f s: 'wheel_max_speed' is %s m/s and 'stop_deceleration' %s m/s^2", duration + kRoundUp,
                 to_text(robot.wheel_max_speed).c_str(), to_text(options.stop_deceleration).c_str()));
}

/// What is planned for the robot must not be more than the wheels are allowed.
void check_acceleration(const Robot& robot, const BridgeOptions& options)
{
  if (options.max_acceleration < robot.max_acceleration)
    reject_option("max_acceleration", to_text(options.max_acceleration),
                  joined("at least 'max_acceleration' of the robot (", to_text(robot.max_acceleration), " m/s^2)"));
}

/// The search for the zero may lead through the whole travel.
void check_homing_time(const Robot& robot, const BridgeOptions& options)
{
  const double duration = 2.0 * robot.wheel_max_angle / homing_rate(robot);
  if (options.homing && options.homing_timeout < duration)
    reject_option(
        "homing_timeout", to_text(options.homing_timeout),
        sentence("at least %.2f s: drives search at a tenth of 'wheel_max_rate' (%s rad/s), and "
                 "'wheel_max_angle' is %s rad",
                 duration + kRoundUp, to_text(robot.wheel_max_rate).c_str(), to_text(robot.wheel_max_angle).c_str()));
}

}  // namespace

void check(const BridgeOptions& options)
{
  check_ranges(options);
  check_nodes(options);
  check_homing(options);
  check_places(options.ranger);
  check_cycle_time(options.cycle_time);
  check_heartbeats(options);
  check_shorter("cycle_time", options.cycle_time, "feedback_timeout", options.feedback_timeout);
}

void check(const Robot& robot, const BridgeOptions& options)
{
  fourwis::check(robot);
  check(options);
  for (const AxisOptions& axis : options.steering) check_counts(robot, options, axis, true);
  for (const AxisOptions& axis : options.driving) check_counts(robot, options, axis, false);
  check_travel(robot, options);
  check_acceleration(robot, options);
  check_stop(robot, options);
  check_homing_time(robot, options);
  check_alignment_timeout(robot, "alignment_timeout", options.alignment_timeout, options.aligned_time);
}

}  // namespace fourwis::can
