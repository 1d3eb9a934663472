#pragma once

#include <functional>
#include <vector>

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/interrupt.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/search/search_options.h"

namespace fourwis
{

struct SearchResult
{
  PlanStatus status = PlanStatus::no_path;  ///< succeeded, goal_unreachable, no_path, timeout or cancelled
  Path path;
  int expansions = 0;
};

/// About how far it is from a pose to the goal, obstacles considered [m].
using DistanceToGoal = std::function<double(const Pose&)>;

/// Hybrid A* over (x, y, theta, mode), the paper's Algorithm 1. Start and goal must be free. Poses expanded are appended
/// to `expanded` where it is not null.
SearchResult hybrid_astar(const CollisionChecker& checker, const Robot& robot, const SearchOptions& options,
                          const PlanRequest& request, const DistanceToGoal& distance, const Interrupt& interrupt,
                          std::vector<Pose>* expanded = nullptr);

}  // namespace fourwis
