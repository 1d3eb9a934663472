#pragma once

#include <vector>

#include "candidates.h"
#include "planning_task.h"

namespace fourwis
{

/// Paths from start to goal, none where the search failed; the result says how it went, and gets its first path, its number of
/// expansions and its time.
std::vector<Candidate> find_paths(const Task& task, Effort effort, PlanResult& result);

}  // namespace fourwis
