#include "options_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/model/sentence.h"
#include "sdo_script.h"

namespace fourwis::can
{
namespace
{

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
}

}  // namespace fourwis::can
