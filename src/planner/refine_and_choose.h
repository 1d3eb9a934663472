#pragma once

#include <vector>

#include "candidates.h"
#include "planning_task.h"

namespace fourwis
{

/// Optimises the paths and fills the result with the fastest trajectory that the referee accepts; when it accepts none, with what
/// comes of the first path with all its stops. There is at least one path.
void refine_and_choose(const Task& task, const std::vector<Candidate>& candidates, PlanResult& result);

}  // namespace fourwis
