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

/// Approximate distance from a pose to the goal, with obstacles considered [m].
using DistanceToGoal = std::function<double(const Pose&)>;

/// Hybrid A* over (x, y, theta, mode), the paper's Algorithm 1. Poses expanded are appended to `expanded` where it is not
/// null. The options need not be in their ranges: Search halves cells and the planner weighs costs. Throws
/// std::invalid_argument unless speed, step and cell are positive, finite numbers.
SearchResult hybrid_astar(const SearchProblem& problem, const SearchOptions& options, const ModeSet& modes,
                          const DistanceToGoal& distance, std::vector<Pose>* expanded = nullptr);

}  // namespace fourwis
