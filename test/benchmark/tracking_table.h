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

/// One line an environment: errors over the drives of so many seeds, and in the last line the paper's.
void report_tracking(const Report& report, const DriveConditions& conditions, int seeds, const std::string& title,
                     const std::vector<PlannedEnvironment>& environments);

/// A way in which conditions differ from the usual ones.
struct Variation
{
  std::string name;
  DriveConditions conditions;
};

/// One line a variation, over all environments.
void report_variations(const Report& report, const std::vector<Variation>& variations, int seeds,
                       const std::vector<PlannedEnvironment>& environments);

/// One line an environment: the robot is pushed by 0.1 m or 10 degrees to either side at a random moment.
void report_pushes(const Report& report, const DriveConditions& conditions, int seeds,
                   const std::vector<PlannedEnvironment>& environments);

}  // namespace fourwis::benchmark
