#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/planner/planner.h"

namespace fourwis
{

using PlanClock = std::chrono::steady_clock;

inline double ms_since(PlanClock::time_point begin)
{
  return std::chrono::duration<double, std::milli>(PlanClock::now() - begin).count();
}

/// Fills the result with the first trajectory that the referee accepts. If it accepts none: with the metrics of the last
/// one, and why not. Returns which.
std::size_t judge(const World& world, const PlanRequest& request, std::vector<Trajectory> trajectories,
                  PlanResult& result);

}  // namespace fourwis
