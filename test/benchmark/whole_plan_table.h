#pragma once

#include <string>
#include <vector>

#include "measurement.h"
#include "problem.h"
#include "table.h"

namespace fourwis::benchmark
{

/// The whole pipeline from the grid to the verified trajectory: for each problem a line of times and a line about the
/// trajectory, each beside what the problem says of another planner, and a summary over them.
void report_whole_plans(const Report& report, const Setup& setup, const std::string& title,
                        const std::vector<Problem>& problems);

}  // namespace fourwis::benchmark
