#pragma once

#include <vector>

#include "measurement.h"
#include "problem.h"
#include "table.h"

namespace fourwis::benchmark
{

/// The paper's environments in all modes and in Ackermann motion only, without regard to setup.modes, at the paper's reference
/// speed and at higher ones, beside the paper's figures. Throws std::runtime_error unless each is one of env1 to env4.
void report_environments(const Report& report, const Setup& setup, const std::vector<Problem>& environments);

}  // namespace fourwis::benchmark
