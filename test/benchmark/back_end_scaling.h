#pragma once

#include <string>
#include <vector>

#include "measurement.h"
#include "problem.h"
#include "table.h"

namespace fourwis::benchmark
{

/// How the time of the back end (corridors, optimisation, certificate) grows with the length of the path: the first
/// candidate path of each problem is refined again and again.
void report_back_end_scaling(const Report& report, const Setup& setup, const std::string& title,
                             const std::vector<Problem>& problems);

}  // namespace fourwis::benchmark
