#include "options_check.h"

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>

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

void check_shorter(const char* shorter, double a, const char* longer, double b)
{
  refuse(!(a < b), std::string(shorter) + " is " + std::to_string(a) + " s, expected less than " + longer + " (" +
                     std::to_string(b) + " s)");
}

}  // namespace

void check(const BridgeOptions& options)
{
  std::set<int> nodes = {options.master_node};
  for (const WheelAxes* axes : {&options.steering, &options.driving})
    for (const AxisOptions& axis : *axes) check_axis(axis, nodes);
  const double milliseconds = options.cycle_time * 1e3;
  refuse(!(milliseconds > 0.5 && std::abs(milliseconds - std::round(milliseconds)) < 1e-6),
         "cycle_time is " + std::to_string(options.cycle_time) + " s, expected whole milliseconds");
  check_shorter("heartbeat_period", options.heartbeat_period, "drive_watchdog", options.drive_watchdog);
  check_shorter("heartbeat_period", options.heartbeat_period, "heartbeat_timeout", options.heartbeat_timeout);
  check_shorter("cycle_time", options.cycle_time, "feedback_timeout", options.feedback_timeout);
}

}  // namespace fourwis::can
