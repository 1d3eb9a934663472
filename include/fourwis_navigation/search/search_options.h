#pragma once

#include <optional>

#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// The front end's parameters; defaults from the paper's Table I where it has them. What is not set follows the robot:
/// lengths are in proportion to its motion_size().
struct SearchOptions
{
  std::optional<double> reference_speed;  ///< v_ref [m/s]; costs in metres are times at this speed
  std::optional<double> step_time;        ///< dt; a primitive is v_ref dt long [s]
  double reverse_penalty = 2.0;           ///< C_rev, per primitive driven backward [m]
  double lateral_reverse_penalty =
      0.0;                        ///< the same for lateral motion to the right; the paper's literal cost has 2 [m]
  double steering_penalty = 1.0;  ///< C_steer, per primitive and radian of steering angle [m/rad]
  double parallel_steering_penalty = 0.0;  ///< the same for parallel motion; the paper's literal cost has 1 [m/rad]
  double steering_change_penalty = 1.0;    ///< C_dsteer, per radian of change between primitives of one mode [m/rad]
  double direction_change_penalty = 1.0;   ///< C_dir, per change of driving direction within a mode [m]
  double heuristic_weight = 3.0;           ///< f = g + weight h; 1 finds the least cost, but is slow
  bool terminal_connection = true;         ///< connect to the goal by multi-modal curves ("RS", Table III)
  bool switching_awareness = true;         ///< C_switch in cost and heuristic ("SCH", Table III)
  std::optional<double> xy_resolution;     ///< side of a cell of the closed list [m]
  double heading_resolution = 0.175;       ///< and its extent in heading [rad]
  double xy_goal_tolerance = 0.25;         ///< what counts as the goal without terminal connection [m]
  double yaw_goal_tolerance = 0.1;         ///< likewise [rad]
  int shortcut_passes = 3;                 ///< how often cheaper curves are looked for along the path
  int max_expansions = 200000;             ///< nodes expanded before the search gives up

  double v_ref(const Robot& robot) const { return reference_speed.value_or(robot.max_speed); }

  /// Length of a primitive [m].
  double primitive_length(const Robot& robot) const
  {
    return step_time ? v_ref(robot) * *step_time : 0.5 * robot.motion_size();
  }

  /// Side of a cell of the closed list [m].
  double cell_size(const Robot& robot) const { return xy_resolution.value_or(0.2 * robot.motion_size()); }

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("reference_speed", o.reference_speed, 0.01, 20.0, "m/s", "max_speed");
    row("step_time", o.step_time, 0.01, 10.0, "s", "from the robot's size and turns");
    row("reverse_penalty", o.reverse_penalty, 0.0, 1000.0, "m");
    row("lateral_reverse_penalty", o.lateral_reverse_penalty, 0.0, 1000.0, "m");
    row("steering_penalty", o.steering_penalty, 0.0, 1000.0, "m/rad");
    row("parallel_steering_penalty", o.parallel_steering_penalty, 0.0, 1000.0, "m/rad");
    row("steering_change_penalty", o.steering_change_penalty, 0.0, 1000.0, "m/rad");
    row("direction_change_penalty", o.direction_change_penalty, 0.0, 1e5, "m");
    row("heuristic_weight", o.heuristic_weight, 0.0, 100.0);
    row("terminal_connection", o.terminal_connection);
    row("switching_awareness", o.switching_awareness);
    row("xy_resolution", o.xy_resolution, 0.01, 5.0, "m", "from the robot's size and turns");
    row("heading_resolution", o.heading_resolution, 0.01, 1.6, "rad");
    row("xy_goal_tolerance", o.xy_goal_tolerance, 0.001, 5.0, "m");
    row("yaw_goal_tolerance", o.yaw_goal_tolerance, 0.001, 3.15, "rad");
    row("shortcut_passes", o.shortcut_passes, 0, 1000);
    row("max_expansions", o.max_expansions, 1, 1e9);
  }
};

/// Throws std::invalid_argument naming key, value and range.
void check(const SearchOptions& options);

}  // namespace fourwis
