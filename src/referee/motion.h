#pragma once

#include "fourwis_navigation/referee/referee.h"
#include "obstacle_cells.h"
#include "rules.h"

namespace fourwis::referee
{

/// Rolls the kinematics out between the points, which must be met, and holds the body's rectangle against the cells all
/// along. Fills in the verdict's clearance and roll-out errors.
void check_motion(const Judgement& judgement, const ObstacleCells& cells, Verdict& verdict);

}  // namespace fourwis::referee
