#pragma once

namespace fourwis
{

/// The front end's parameters; defaults from the paper's Table I where it has them.
struct SearchOptions
{
  double reference_speed = 1.0;  ///< v_ref [m/s]
  double step_time = 0.5;        ///< dt; a primitive is v_ref dt long [s]
  double reverse_penalty = 2.0;  ///< C_rev, per primitive driven backward [m]
  double lateral_reverse_penalty =
      0.0;                        ///< the same for lateral motion to the right; the paper's literal cost has 2 [m]
  double steering_penalty = 1.0;  ///< C_steer, per primitive and radian of steering angle [m/rad]
  double parallel_steering_penalty = 0.0;  ///< the same for parallel motion; the paper's literal cost has 1 [m/rad]
  double steering_change_penalty = 1.0;    ///< C_dsteer, per radian of change between primitives of one mode [m/rad]
  double direction_change_penalty = 1.0;   ///< C_dir, per change of driving direction within a mode [m]
  double heuristic_weight = 3.0;           ///< f = g + weight h; 1 searches for the least cost, and long
  bool terminal_connection = true;         ///< connect to the goal by multi-modal curves ("RS", Table III)
  bool switching_awareness = true;         ///< C_switch in cost and heuristic ("SCH", Table III)
  double xy_resolution = 0.2;              ///< side of a cell of the closed list [m]
  double heading_resolution = 0.175;       ///< and its extent in heading [rad]
  double xy_goal_tolerance = 0.25;         ///< what counts as the goal without terminal connection [m]
  double yaw_goal_tolerance = 0.1;         ///< likewise [rad]
  int shortcut_passes = 3;                 ///< how often the path found is gone over for cheaper curves
  int max_expansions = 200000;             ///< nodes expanded before the search gives up

  /// Length of a primitive [m].
  double primitive_length() const { return reference_speed * step_time; }
};

}  // namespace fourwis
