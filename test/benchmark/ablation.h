#pragma once

#include "measurement.h"
#include "problem.h"
#include "table.h"

namespace fourwis::benchmark
{

/// The paper's Table III: the front end with and without terminal connection ("RS") and switching awareness ("SCH"), on
/// one problem, beside the paper's figures.
void report_ablation(const Report& report, const Setup& setup, const Problem& problem);

}  // namespace fourwis::benchmark
