#pragma once

#include <functional>
#include <vector>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/search/search_options.h"
#include "fourwis_navigation/search/search_problem.h"

namespace fourwis
{

struct SearchResult
{
  PlanStatus status = PlanStatus::no_path;  ///< succeeded, goal_unreachable, no_path, timeout or cancelled
  Path path;
  int expansions = 0;
};

/// What guides a search.
struct Guide
{
  /// Approximate distance from a pose to the goal, with obstacles considered [m].
  std::function<double(const Pose&)> distance;

  /// Where a robot goes on from a pose if it keeps its heading: poses one after the other. May be empty.
  std::function<void(const Pose&, std::vector<Pose>&)> way_ahead = {};

  /// Where it is positive, arcs end at multiples of it [rad], so that the robot is in line with what the guide knows.
  double heading_step = 0.0;
};

/// Hybrid A* over (x, y, theta, mode), the paper's Algorithm 1. Poses expanded are appended to `expanded` where it is not
/// null. The options need not be in their ranges: Search halves cells and the planner weighs costs. Throws
/// std::invalid_argument unless speed, step and cell are positive, finite numbers.
SearchResult hybrid_astar(const SearchProblem& problem, const SearchOptions& options, const ModeSet& modes,
                          const Guide& guide, std::vector<Pose>* expanded = nullptr);

}  // namespace fourwis
