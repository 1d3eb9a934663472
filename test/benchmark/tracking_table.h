#pragma once

#include <string>
#include <vector>

#include "measurement.h"
#include "problem.h"
#include "simulated_drive.h"
#include "table.h"

namespace fourwis::benchmark
{

/// An environment with its plan.
struct PlannedEnvironment
{
  std::string id;
  const OccupancyGrid grid;
  const Trajectory trajectory;
};

/// Plans each problem once. Throws std::runtime_error where there is no plan.
std::vector<PlannedEnvironment> plan_environments(const Setup& setup, const std::vector<Problem>& problems);

/// One line an environment: errors over all drives of `setup.runs` seeds, and in the last line the paper's where it has them.
void report_tracking(const Report& report, const Circumstances& circumstances, int seeds, const std::string& title,
                     const std::vector<PlannedEnvironment>& environments, bool beside_paper);

/// One line an environment: pushes of 0.1 m or 10 degrees to each side at random moments.
void report_pushes(const Report& report, const Circumstances& circumstances, int seeds,
                   const std::vector<PlannedEnvironment>& environments);

}  // namespace fourwis::benchmark
