#pragma once

#include "fourwis_navigation/planner/verify.h"
#include "verify_cells.h"
#include "verify_promises.h"

namespace fourwis::verify
{

/// Rolls the kinematics out between the points, which must be met, and holds the body's rectangle against the cells all
/// along. Fills in the verdict's clearance and roll-out errors.
void check_motion(const Court& court, const ObstacleCells& cells, Verdict& verdict);

}  // namespace fourwis::verify
