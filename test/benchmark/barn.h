#pragma once

#include <string>

#include "measurement.h"
#include "table.h"

namespace fourwis::benchmark
{

/// How many of the BARN maps of `folder` the planner gets through, with setup.robot and with one of the size the
/// dataset was drawn for, and how many of those where that is possible at all. With an `export_folder`, which must
/// exist, also writes all of it there as maps with a problems.csv for each robot.
void report_barn(const Report& report, const Setup& setup, const std::string& folder, const std::string& export_folder);

}  // namespace fourwis::benchmark
