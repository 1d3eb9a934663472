#pragma once

#include <string>
#include <utility>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// What became of a planning request. Everything but `succeeded` is an expected failure with numbers in the message.
enum class PlanStatus
{
  succeeded,
  start_in_collision,
  goal_in_collision,
  goal_unreachable,     ///< proven: not even free motion gets there, or parallel motion alone would have to turn
  no_path,              ///< the search gave up: nothing left to expand, or its expansions are used up
  timeout,              ///< planner_patience is over
  not_converged,        ///< the optimisation failed and no fallback was allowed
  verification_failed,  ///< the referee rejected every candidate
  cancelled,
  invalid_input
};

inline const char* to_string(PlanStatus status)
{
  switch (status)
  {
    case PlanStatus::succeeded: return "succeeded";
    case PlanStatus::start_in_collision: return "start_in_collision";
    case PlanStatus::goal_in_collision: return "goal_in_collision";
    case PlanStatus::goal_unreachable: return "goal_unreachable";
    case PlanStatus::no_path: return "no_path";
    case PlanStatus::timeout: return "timeout";
    case PlanStatus::not_converged: return "not_converged";
    case PlanStatus::verification_failed: return "verification_failed";
    case PlanStatus::cancelled: return "cancelled";
    case PlanStatus::invalid_input: return "invalid_input";
  }
  return "invalid_input";
}

/// The question: from rest at `start` to rest at `goal`, both poses of base_link in the map frame.
struct PlanRequest
{
  Pose start;
  Pose goal;
  ModeSet modes;
  bool frontend_only =
      false;  ///< no optimisation: the front end's path, driven with stops wherever the steering changes
  /// How far x and y of the goal may be relaxed where it has no plan; its heading stays [m]. 0: not at all.
  double goal_tolerance = 0.0;
};

/// The paper's section V-A.2, and where the time went. Metrics of the trajectory are those of the one
/// refused where the status is verification_failed, and zero where there was none.
struct PlanMetrics
{
  bool safe = false;                     ///< SF, what the referee says
  double length = 0.0;                   ///< TL [m]
  double arrival_time = 0.0;             ///< AT [s]
  double mean_curvature = 0.0;           ///< AC [1/m], within stretches of one mode and one direction
  double max_curvature = 0.0;            ///< MC [1/m], likewise
  double terminal_position_error = 0.0;  ///< TPE [m]
  double terminal_yaw_error = 0.0;       ///< TYE [rad]
  double standard_mode_rate = 0.0;       ///< SMR, 0..1
  double total_ms = 0.0;                 ///< CT: grid to verified trajectory, wall clock
  double map_ms = 0.0;                   ///< of it: obstacle map
  double frontend_ms = 0.0;              ///< of it: obstacle map, search and speed profile
  double backend_ms = 0.0;               ///< of it: corridors and optimisation
  double verify_ms = 0.0;                ///< of it: the referee
  int expansions = 0;                    ///< nodes the search expanded
  int switches = 0;                      ///< mode switches in the trajectory
  int outer_iterations = 0;              ///< corridor-optimisation rounds, most of all segments
  int ipopt_iterations = 0;              ///< NLP iterations, sum over segments and rounds
  double min_clearance = 0.0;  ///< least distance from the exact rectangle to an obstacle along the trajectory [m]
};

struct PlanResult
{
  PlanStatus status = PlanStatus::invalid_input;
  std::string message;    ///< one sentence with numbers, for a person
  Trajectory trajectory;  ///< what the referee accepted, of base_link; empty unless succeeded
  Path path;              ///< the front end's, of C, the centre of the wheels
  PlanMetrics metrics;
  std::string candidate;  ///< which of the searches found the path: its modes and costs
  /// Parts between switches, or runs between cusps, that are driven with stops because their optimisation failed.
  int fallback_parts = 0;
  double overlap = 0.0;   ///< by how much the sides of the body have to be moved inward to be free at the start [m]
  bool degraded = false;  ///< whether the deadline cut the work short
};

/// A result that is no plan: the status says of which kind, the message why.
inline PlanResult no_plan(PlanStatus status, std::string message)
{
  PlanResult result;
  result.status = status;
  result.message = std::move(message);
  return result;
}

}  // namespace fourwis
