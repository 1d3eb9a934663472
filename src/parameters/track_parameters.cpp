#include "parameter_table.h"

namespace fourwis
{
namespace
{

template <class Value>
auto track(Value TrackOptions::*member)
{
  return [member](TrackOptions& options) -> Slot { return &(options.*member); };
}

const ParameterTable<TrackOptions>& track_table()
{
  using O = TrackOptions;
  static const ParameterTable<TrackOptions> table = {
    {"controller_frequency", track(&O::controller_frequency), 5.0, 500.0, "Hz"},

    {"horizon", track(&O::horizon), 0.4, 10.0, "s"},
    {"knots", track(&O::knots), 2, 200},
    {"lateral_scale", track(&O::lateral_scale), 1e-3, 1e3, "m"},
    {"longitudinal_scale", track(&O::longitudinal_scale), 1e-3, 1e3, "m"},
    {"heading_scale", track(&O::heading_scale), 1e-3, 1e3, "rad"},
    {"speed_scale", track(&O::speed_scale), 1e-3, 1e3, "m/s"},
    {"steering_scale", track(&O::steering_scale), 1e-3, 1e3, "rad"},
    {"acceleration_scale", track(&O::acceleration_scale), 1e-3, 1e3, "m/s^2"},
    {"steering_rate_scale", track(&O::steering_rate_scale), 1e-3, 1e3, "rad/s"},

    {"command_latency", track(&O::command_latency), 0.0, 0.5, "s"},
    {"drive_lag", track(&O::drive_lag), 0.0, 0.5, "s"},
    {"steering_lag", track(&O::steering_lag), 0.0, 0.5, "s"},

    {"xy_goal_tolerance", track(&O::xy_goal_tolerance), 1e-3, 1.0, "m"},
    {"yaw_goal_tolerance", track(&O::yaw_goal_tolerance), 1e-3, 3.15, "rad"},
    {"xy_switch_tolerance", track(&O::xy_switch_tolerance), 1e-3, 1.0, "m"},
    {"yaw_switch_tolerance", track(&O::yaw_switch_tolerance), 1e-3, 3.15, "rad"},
    {"correction_speed", track(&O::correction_speed), 0.01, 1.0, "m/s"},
    {"correction_timeout", track(&O::correction_timeout), 0.0, 600.0, "s"},
    {"settle_time", track(&O::settle_time), 0.0, 60.0, "s"},
    {"rest_speed", track(&O::rest_speed), 1e-4, 1.0, "m/s"},
    {"alignment_timeout", track(&O::alignment_timeout), 0.0, 600.0, "s"},

    {"max_lateral_error", track(&O::max_lateral_error), 1e-3, 3.0, "m"},
    {"max_longitudinal_error", track(&O::max_longitudinal_error), 1e-3, 3.0, "m"},
    {"max_heading_error", track(&O::max_heading_error), 1e-3, 3.15, "rad"},
    {"max_wheel_error", track(&O::max_wheel_error), 1e-2, 3.15, "rad"},
    {"clock_slack", track(&O::clock_slack), 1e-3, 3.0, "m"},
    {"pose_timeout", track(&O::pose_timeout), 0.0, 60.0, "s"},
    {"wheel_state_timeout", track(&O::wheel_state_timeout), 0.0, 60.0, "s"},
    {"step_timeout", track(&O::step_timeout), 0.0, 60.0, "s"},
  };
  return table;
}

}  // namespace

TrackOptions track_options_from(const ParameterMap& parameters)
{
  return options_from(track_table(), parameters);
}

}  // namespace fourwis
