#include "fourwis_navigation/track/track_options.h"

#include <algorithm>

#include "forecast.h"
#include "fourwis_navigation/model/option_range.h"

namespace fourwis
{

const std::vector<TrackOptionRange>& track_option_ranges()
{
  using O = TrackOptions;
  static const std::vector<TrackOptionRange> ranges = {
      {"controller_frequency", &O::controller_frequency, 5.0, 500.0, "Hz"},

      {"horizon", &O::horizon, 0.4, 10.0, "s"},
      {"knots", &O::knots, 2, 200, ""},
      {"lateral_scale", &O::lateral_scale, 1e-3, 1e3, "m"},
      {"longitudinal_scale", &O::longitudinal_scale, 1e-3, 1e3, "m"},
      {"heading_scale", &O::heading_scale, 1e-3, 1e3, "rad"},
      {"speed_scale", &O::speed_scale, 1e-3, 1e3, "m/s"},
      {"steering_scale", &O::steering_scale, 1e-3, 1e3, "rad"},
      {"acceleration_scale", &O::acceleration_scale, 1e-3, 1e3, "m/s^2"},
      {"steering_rate_scale", &O::steering_rate_scale, 1e-3, 1e3, "rad/s"},

      {"command_latency", &O::command_latency, 0.0, 0.5, "s"},
      {"drive_lag", &O::drive_lag, 0.0, 0.5, "s"},
      {"steering_lag", &O::steering_lag, 0.0, 0.5, "s"},

      {"xy_start_tolerance", &O::xy_start_tolerance, 1e-3, 1.0, "m"},
      {"yaw_start_tolerance", &O::yaw_start_tolerance, 1e-3, 3.15, "rad"},
      {"xy_goal_tolerance", &O::xy_goal_tolerance, 1e-3, 1.0, "m"},
      {"yaw_goal_tolerance", &O::yaw_goal_tolerance, 1e-3, 3.15, "rad"},
      {"xy_switch_tolerance", &O::xy_switch_tolerance, 1e-3, 1.0, "m"},
      {"yaw_switch_tolerance", &O::yaw_switch_tolerance, 1e-3, 3.15, "rad"},
      {"max_xy_correction", &O::max_xy_correction, 1e-3, 1.0, "m"},
      {"max_yaw_correction", &O::max_yaw_correction, 1e-3, 3.15, "rad"},
      {"correction_speed", &O::correction_speed, 0.01, 1.0, "m/s"},
      {"correction_timeout", &O::correction_timeout, 0.0, 600.0, "s"},
      {"settle_time", &O::settle_time, 0.0, 60.0, "s"},
      {"rest_speed", &O::rest_speed, 1e-4, 1.0, "m/s"},
      {"alignment_timeout", &O::alignment_timeout, 0.0, 600.0, "s"},

      {"max_lateral_error", &O::max_lateral_error, 1e-3, 3.0, "m"},
      {"max_longitudinal_error", &O::max_longitudinal_error, 1e-3, 3.0, "m"},
      {"max_heading_error", &O::max_heading_error, 1e-3, 3.15, "rad"},
      {"max_wheel_error", &O::max_wheel_error, 1e-2, 3.15, "rad"},
      {"clock_slack", &O::clock_slack, 1e-3, 3.0, "m"},
      {"pose_timeout", &O::pose_timeout, 0.01, 2.0, "s"},
      {"wheel_state_timeout", &O::wheel_state_timeout, 0.01, 2.0, "s"},
      {"step_timeout", &O::step_timeout, 0.01, 60.0, "s"},
  };
  return ranges;
}

void check(const TrackOptions& options)
{
  for (const TrackOptionRange& range : track_option_ranges())
    std::visit([&](auto member) { require_between(range.name, options.*member, range.min, range.max); }, range.member);
  require_between("horizon * controller_frequency", options.horizon * options.controller_frequency, 2.0, 5000.0);
  const double remembered = options.command_latency + std::max(options.pose_timeout, options.wheel_state_timeout);
  require_between("(command_latency + the greater of pose_timeout and wheel_state_timeout) * controller_frequency",
                  remembered * options.controller_frequency, 0.0, Forecast::kSteps);
}

}  // namespace fourwis
