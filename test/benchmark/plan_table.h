#pragma once

#include <string>
#include <vector>

#include "measurement.h"
#include "problem.h"
#include "table.h"

namespace fourwis::benchmark
{

/// One line a problem, and a summary over them.
void report_plans(const Report& report, const Setup& setup, const std::string& title,
                  const std::vector<Problem>& problems);

}  // namespace fourwis::benchmark
