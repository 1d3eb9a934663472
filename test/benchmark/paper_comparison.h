#pragma once

#include <vector>

#include "measurement.h"
#include "problem.h"
#include "table.h"

namespace fourwis::benchmark
{

/// The paper's back end as it stands beside the default one, on the front end's paths through the environments in
/// Ackermann motion: what both make of the same path, what the referee says, and how long they take.
void report_paper_comparison(const Report& report, const Setup& setup, const std::vector<Problem>& environments);

}  // namespace fourwis::benchmark
