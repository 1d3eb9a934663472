#pragma once

#include <string>
#include <vector>

#include "measurement.h"
#include "table.h"

namespace fourwis::benchmark
{

/// Plans across large maps, from the free place nearest to the lower left corner to that nearest to the upper right
/// one, with the time and the peak memory it takes. Both places are in the largest region in which the robot can
/// turn anywhere.
void report_corner_to_corner(const Report& report, const Setup& setup, const std::vector<std::string>& maps);

}  // namespace fourwis::benchmark
