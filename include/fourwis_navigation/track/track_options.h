#pragma once

#include <cmath>

#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// How trajectories are tracked; the keys of config/mpc.yaml.
struct TrackOptions
{
  double controller_frequency = 50.0;  ///< control steps each second [Hz]; the paper's controller has 20

  // The model-predictive controller. Its cost compares deviations by their `..._scale`: two deviations cost the same if
  // each is as large as its own scale.
  double horizon = 1.0;              ///< how far it looks ahead [s]
  int knots = 25;                    ///< intervals of the horizon; the first is one control step long
  double lateral_scale = 0.02;       ///< across the direction of travel [m]
  double longitudinal_scale = 0.04;  ///< along it [m]
  double heading_scale = 0.05;       ///< [rad]
  double speed_scale = 0.5;          ///< [m/s]
  double steering_scale = 0.5;       ///< of phi [rad]
  double acceleration_scale = 4.0;   ///< of a [m/s^2]
  double steering_rate_scale = 2.0;  ///< of omega [rad/s]

  // What is known of the base between a measurement and what a command does.
  double command_latency = 0.02;  ///< from a measurement to the effect of its command [s]
  double drive_lag = 0.03;        ///< time constant of the wheels' speeds [s]
  double steering_lag = 0.02;     ///< time constant of the wheels' angles [s]

  // Start, switches and goal.
  double xy_start_tolerance = 0.03;              ///< distance from the trajectory's beginning at which it starts [m]
  double yaw_start_tolerance = 0.03;             ///< likewise [rad]
  double xy_goal_tolerance = 0.01;               ///< distance from the goal at which it is reached [m]
  double yaw_goal_tolerance = 0.5 * M_PI / 180;  ///< likewise [rad]
  double xy_switch_tolerance = 0.03;             ///< likewise from the place of a switch [m]
  double yaw_switch_tolerance = 0.03;            ///< likewise [rad]
  double max_xy_correction = 0.05;               ///< a robot that rests farther from its place is not corrected [m]
  double max_yaw_correction = 0.1;               ///< likewise [rad]
  double correction_speed = 0.1;                 ///< of the creeping motion that removes what is left over [m/s]
  double correction_timeout = 10.0;              ///< longest duration of a correction with its alignments [s]
  double settle_time = 0.5;                      ///< after the end of a stretch, to remove the longitudinal error [s]
  double rest_speed = 0.01;                      ///< a wheel that rolls no faster is at rest [m/s]
  double alignment_timeout = 5.0;                ///< the wheels must be aligned by then [s]

  // What stops the robot.
  double max_lateral_error = 0.15;      ///< [m]
  double max_longitudinal_error = 0.3;  ///< [m]
  double max_heading_error = 0.3;       ///< [rad]
  double max_wheel_error = 0.15;        ///< of a wheel's angle, for longer than 0.3 s [rad]
  double clock_slack = 0.02;            ///< if the robot is farther behind, the clock goes slower [m]
  double pose_timeout = 0.1;            ///< greatest age of the pose [s]
  double wheel_state_timeout = 0.1;     ///< greatest age of the wheels' state [s]
  double step_timeout = 0.3;            ///< longest time from one control step to the next [s]
  double permit_timeout = 0.3;          ///< greatest age of the permission to drive [s]

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("controller_frequency", o.controller_frequency, 5.0, 500.0, "Hz");

    row("horizon", o.horizon, 0.4, 10.0, "s");
    row("knots", o.knots, 2, 200);
    row("lateral_scale", o.lateral_scale, 1e-3, 1e3, "m");
    row("longitudinal_scale", o.longitudinal_scale, 1e-3, 1e3, "m");
    row("heading_scale", o.heading_scale, 1e-3, 1e3, "rad");
    row("speed_scale", o.speed_scale, 1e-3, 1e3, "m/s");
    row("steering_scale", o.steering_scale, 1e-3, 1e3, "rad");
    row("acceleration_scale", o.acceleration_scale, 1e-3, 1e3, "m/s^2");
    row("steering_rate_scale", o.steering_rate_scale, 1e-3, 1e3, "rad/s");

    row("command_latency", o.command_latency, 0.0, 0.5, "s");
    row("drive_lag", o.drive_lag, 0.0, 0.5, "s");
    row("steering_lag", o.steering_lag, 0.0, 0.5, "s");

    row("xy_start_tolerance", o.xy_start_tolerance, 1e-3, 1.0, "m");
    row("yaw_start_tolerance", o.yaw_start_tolerance, 1e-3, 3.15, "rad");
    row("xy_goal_tolerance", o.xy_goal_tolerance, 1e-3, 1.0, "m");
    row("yaw_goal_tolerance", o.yaw_goal_tolerance, 1e-3, 3.15, "rad");
    row("xy_switch_tolerance", o.xy_switch_tolerance, 1e-3, 1.0, "m");
    row("yaw_switch_tolerance", o.yaw_switch_tolerance, 1e-3, 3.15, "rad");
    row("max_xy_correction", o.max_xy_correction, 1e-3, 1.0, "m");
    row("max_yaw_correction", o.max_yaw_correction, 1e-3, 3.15, "rad");
    row("correction_speed", o.correction_speed, 0.01, 1.0, "m/s");
    row("correction_timeout", o.correction_timeout, 0.0, 600.0, "s");
    row("settle_time", o.settle_time, 0.0, 60.0, "s");
    row("rest_speed", o.rest_speed, 1e-4, 1.0, "m/s");
    row("alignment_timeout", o.alignment_timeout, 0.0, 600.0, "s");

    row("max_lateral_error", o.max_lateral_error, 1e-3, 3.0, "m");
    row("max_longitudinal_error", o.max_longitudinal_error, 1e-3, 3.0, "m");
    row("max_heading_error", o.max_heading_error, 1e-3, 3.15, "rad");
    row("max_wheel_error", o.max_wheel_error, 1e-2, 3.15, "rad");
    row("clock_slack", o.clock_slack, 1e-3, 3.0, "m");
    row("pose_timeout", o.pose_timeout, 0.01, 2.0, "s");
    row("wheel_state_timeout", o.wheel_state_timeout, 0.01, 2.0, "s");
    row("step_timeout", o.step_timeout, 0.01, 60.0, "s");
    row("permit_timeout", o.permit_timeout, 0.1, 60.0, "s");
  }
};

/// Throws std::invalid_argument naming key, value and range. Some ranges depend on other options.
void check(const TrackOptions& options);

/// The same, and where they contradict the robot.
void check(const Robot& robot, const TrackOptions& options);

}  // namespace fourwis
