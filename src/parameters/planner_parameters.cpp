#include "parameter_table.h"

namespace fourwis
{
namespace
{

template <class Value>
auto obstacles(Value ObstacleRule::*member)
{
  return [member](PlannerOptions& options) -> Slot { return &(options.obstacles.*member); };
}

template <class Value>
auto search(Value SearchOptions::*member)
{
  return [member](PlannerOptions& options) -> Slot { return &(options.search.*member); };
}

template <class Value>
auto optimize(Value OptimizeOptions::*member)
{
  return [member](PlannerOptions& options) -> Slot { return &(options.optimize.*member); };
}

template <class Value>
auto referee(Value RefereeOptions::*member)
{
  return [member](PlannerOptions& options) -> Slot { return &(options.referee.*member); };
}

template <class Value>
auto planner(Value PlannerOptions::*member)
{
  return [member](PlannerOptions& options) -> Slot { return &(options.*member); };
}

const ParameterTable<PlannerOptions>& planner_table()
{
  static const ParameterTable<PlannerOptions> table = {
      {"occupied_threshold", obstacles(&ObstacleRule::occupied_threshold), 1, 100, "percent"},
      {"unknown_is_obstacle", obstacles(&ObstacleRule::unknown_is_obstacle)},

      {"reference_speed", search(&SearchOptions::reference_speed), 0.01, 20.0, "m/s"},
      {"step_time", search(&SearchOptions::step_time), 0.01, 10.0, "s"},
      {"reverse_penalty", search(&SearchOptions::reverse_penalty), 0.0, 1000.0, "m"},
      {"lateral_reverse_penalty", search(&SearchOptions::lateral_reverse_penalty), 0.0, 1000.0, "m"},
      {"steering_penalty", search(&SearchOptions::steering_penalty), 0.0, 1000.0, "m/rad"},
      {"parallel_steering_penalty", search(&SearchOptions::parallel_steering_penalty), 0.0, 1000.0, "m/rad"},
      {"steering_change_penalty", search(&SearchOptions::steering_change_penalty), 0.0, 1000.0, "m/rad"},
      {"direction_change_penalty", search(&SearchOptions::direction_change_penalty), 0.0, 1000.0, "m"},
      {"heuristic_weight", search(&SearchOptions::heuristic_weight), 0.0, 100.0},
      {"terminal_connection", search(&SearchOptions::terminal_connection)},
      {"switching_awareness", search(&SearchOptions::switching_awareness)},
      {"xy_resolution", search(&SearchOptions::xy_resolution), 0.01, 5.0, "m"},
      {"heading_resolution", search(&SearchOptions::heading_resolution), 0.01, 1.6, "rad"},
      {"xy_goal_tolerance", search(&SearchOptions::xy_goal_tolerance), 0.001, 5.0, "m"},
      {"yaw_goal_tolerance", search(&SearchOptions::yaw_goal_tolerance), 0.001, 3.15, "rad"},
      {"shortcut_passes", search(&SearchOptions::shortcut_passes), 0, 1000},
      {"max_expansions", search(&SearchOptions::max_expansions), 1, 1e9},

      {"solver",
       [](PlannerOptions& o) -> Slot {
         return choice(o.optimize.solver, {"structured", "ipopt"});
       }},
      {"formulation",
       [](PlannerOptions& o) -> Slot {
         return choice(o.optimize.formulation, {"default", "paper"});
       }},
      {"knot_spacing", optimize(&OptimizeOptions::spacing), 0.01, 2.0, "m"},
      {"steering_comfort", optimize(&OptimizeOptions::steering_comfort), 0.0, 100.0},
      {"interval_weight", optimize(&OptimizeOptions::interval_weight), 0.0, 100.0, "1/s"},
      {"corridor_weight", optimize(&OptimizeOptions::corridor_weight), 1.0, 1e6, "s/m"},
      {"shortest_interval", optimize(&OptimizeOptions::shortest_interval), 0.01, 0.9},
      {"longest_interval", optimize(&OptimizeOptions::longest_interval), 1.1, 100.0},
      {"longest_at_rest", optimize(&OptimizeOptions::longest_at_rest), 2.0, 100.0},
      {"corridor_discs", optimize(&OptimizeOptions::corridor_discs), 1, 8},
      {"polish_discs", optimize(&OptimizeOptions::polish_discs), 1, 8},
      {"corridor_range", optimize(&OptimizeOptions::corridor_range), 0.1, 20.0, "m"},
      {"outer_iterations", optimize(&OptimizeOptions::outer_iterations), 1, 20},
      {"repairs", optimize(&OptimizeOptions::repairs), 0, 20},

      // The referee's other tolerances are the meaning of a trajectory, not a matter of taste.
      {"collision_step", referee(&RefereeOptions::collision_step), 0.0005, 0.01, "m"},
      {"planner_patience", planner(&PlannerOptions::planner_patience), 0.001, 3600.0, "s"},
  };
  return table;
}

}  // namespace

PlannerOptions planner_options_from(const ParameterMap& parameters)
{
  return options_from(planner_table(), parameters);
}

}  // namespace fourwis
