#include "options_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "sdo_script.h"

namespace fourwis::can
{
namespace
{

void refuse(bool wrong, const std::string& what)
{
  if (wrong) throw std::invalid_argument(what);
}

void check_axis(const AxisOptions& axis, std::set<int>& nodes)
{
  const std::string node = std::to_string(axis.node);
  refuse(axis.node < 1 || axis.node > 127, "node is " + node + ", expected 1 to 127");
  refuse(!nodes.insert(axis.node).second, "node " + node + " is given to two axes or is also master_node");
  refuse(!(axis.counts_per_turn * axis.gear_ratio > 0.0),
         "counts_per_turn * gear_ratio of node " + node + " is not positive");
}

/// What a drive's 32 bits cannot hold would reach it as something else: angles, speeds (with sign), accelerations.
void check_counts(const Robot& robot, const BridgeOptions& options, const AxisOptions& axis, bool steering)
{
  const double counts = std::abs(scale_of(options, axis, steering).counts_per_unit());
  const Ramps ramps = ramps_of(robot, options, steering);
  const double travel = steering ? robot.wheel_max_angle + std::abs(axis.offset) : 0.0;
  const double greatest = std::max({travel, ramps.speed, 0.5 * ramps.acceleration, 0.5 * ramps.deceleration});
  refuse(greatest * counts > std::numeric_limits<std::int32_t>::max(),
         "node " + std::to_string(axis.node) + " would need more than 32 bits for its angle, speed or acceleration: " +
             std::to_string(counts) + " counts in a radian or metre are too many");
}

/// Methods that search nothing but declare a zero: every start would declare another one.
void check_homing(const BridgeOptions& options)
{
  const int method = options.homing_method;
  refuse(options.homing && (method == 0 || method == 35 || method == 37),
         "homing_method is " + std::to_string(method) + ", expected one that finds the zero of a steering drive");
}

/// The base's other modes have fixed numbers: of the first three each is one of ours.
void check_ranger(const RangerOptions& ranger)
{
  const std::set<int> places(ranger.place.begin(), ranger.place.end());
  refuse(places != std::set<int>{1, 2, 3, 4}, "ranger/place is not each of 1 to 4 once");
  refuse(ranger.side_slip_mode < 3, "ranger/side_slip_mode is " + std::to_string(ranger.side_slip_mode) +
                                        ", the number of another mode, expected 3 or more");
}

void check_cycle_time(double cycle_time)
{
  const double milliseconds = cycle_time * 1e3;
  refuse(!(milliseconds > 0.5 && std::abs(milliseconds - std::round(milliseconds)) < 1e-6),
         "cycle_time is " + std::to_string(cycle_time) + " s, expected whole milliseconds");
}

void check_shorter(const char* shorter, double a, const char* longer, double b)
{
  refuse(!(a < b), std::string(shorter) + " is " + std::to_string(a) + " s, expected less than " + longer + " (" +
                       std::to_string(b) + " s)");
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

}  // namespace

void check(const Robot& robot, const BridgeOptions& options)
{
  std::set<int> nodes = {options.master_node};
  for (const WheelAxes* axes : {&options.steering, &options.driving})
    for (const AxisOptions& axis : *axes) check_axis(axis, nodes);
  for (const AxisOptions& axis : options.steering) check_counts(robot, options, axis, true);
  for (const AxisOptions& axis : options.driving) check_counts(robot, options, axis, false);
  check_homing(options);
  check_ranger(options.ranger);
  check_cycle_time(options.cycle_time);
  check_heartbeats(options);
  check_shorter("cycle_time", options.cycle_time, "feedback_timeout", options.feedback_timeout);
}

}  // namespace fourwis::can
