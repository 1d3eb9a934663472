#pragma once

#include "fourwis_navigation/referee/referee.h"
#include "obstacle_cells.h"
#include "rules.h"

namespace fourwis::referee
{

/// Rolls the kinematics out from each point; the result must meet the next point. Checks the body's rectangle against
/// the cells along the whole motion. Fills in the verdict's clearance and roll-out errors.
void check_motion(const Judgement& judgement, const ObstacleCells& cells, Verdict& verdict);

}  // namespace fourwis::referee
