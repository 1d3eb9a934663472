#pragma once

#include <vector>

#include "fourwis_navigation/search/hybrid_astar.h"

namespace fourwis
{

/// The front end, the paper's section III-A: goal distance, proof of unreachability, 4D Hybrid A*, shortcuts. Start and goal
/// must be free. Poses expanded are appended to `expanded` where it is not null.
SearchResult find_path(const CollisionChecker& checker, const Robot& robot, const SearchOptions& options,
                       const PlanRequest& request, const Interrupt& interrupt, std::vector<Pose>* expanded = nullptr);

}  // namespace fourwis
