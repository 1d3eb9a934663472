#pragma once

#include <string>
#include <vector>

#include "measurement.h"
#include "problem.h"
#include "table.h"

namespace fourwis::benchmark
{

/// Each problem twice, made unsolvable: with a ring of obstacles around the goal in which the robot can just turn,
/// and with a straight wall across the whole map halfway between start and goal. How soon is that noticed?
void report_walled_in(const Report& report, const Setup& setup, const std::string& title,
                      const std::vector<Problem>& problems);

}  // namespace fourwis::benchmark
