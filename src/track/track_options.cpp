#include "fourwis_navigation/track/track_options.h"

#include <sstream>
#include <stdexcept>

namespace fourwis
{
namespace
{

void check(const char* name, double value, double least, double greatest)
{
  if (value >= least && value <= greatest) return;
  std::ostringstream text;
  text << "tracking option " << name << " = " << value << ": must lie between " << least << " and " << greatest;
  throw std::invalid_argument(text.str());
}

}  // namespace

void check(const TrackOptions& options)
{
  check("controller_frequency", options.controller_frequency, 5.0, 500.0);
  check("horizon", options.horizon, 0.4, 10.0);
  check("knots", options.knots, 2, 200);
  check("horizon * controller_frequency", options.horizon * options.controller_frequency, 2.0, 5000.0);
  for (const auto& [name, scale] : {std::pair("lateral_scale", options.lateral_scale),
                                    {"longitudinal_scale", options.longitudinal_scale},
                                    {"heading_scale", options.heading_scale},
                                    {"speed_scale", options.speed_scale},
                                    {"steering_scale", options.steering_scale},
                                    {"acceleration_scale", options.acceleration_scale},
                                    {"steering_rate_scale", options.steering_rate_scale}})
    check(name, scale, 1e-3, 1e3);
  check("command_latency", options.command_latency, 0.0, 0.5);
  check("drive_lag", options.drive_lag, 0.0, 0.5);
  check("steering_lag", options.steering_lag, 0.0, 0.5);
  for (const auto& [name, value] : {std::pair("xy_goal_tolerance", options.xy_goal_tolerance),
                                    {"yaw_goal_tolerance", options.yaw_goal_tolerance},
                                    {"xy_switch_tolerance", options.xy_switch_tolerance},
                                    {"yaw_switch_tolerance", options.yaw_switch_tolerance},
                                    {"correction_speed", options.correction_speed},
                                    {"rest_speed", options.rest_speed},
                                    {"max_lateral_error", options.max_lateral_error},
                                    {"max_longitudinal_error", options.max_longitudinal_error},
                                    {"max_heading_error", options.max_heading_error},
                                    {"max_wheel_error", options.max_wheel_error},
                                    {"clock_slack", options.clock_slack}})
    check(name, value, 1e-4, 3.2);
  for (const auto& [name, time] : {std::pair("correction_timeout", options.correction_timeout),
                                   {"settle_time", options.settle_time},
                                   {"alignment_timeout", options.alignment_timeout},
                                   {"pose_timeout", options.pose_timeout},
                                   {"wheel_state_timeout", options.wheel_state_timeout},
                                   {"step_timeout", options.step_timeout}})
    check(name, time, 0.0, 600.0);
}

}  // namespace fourwis
