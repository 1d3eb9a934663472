#pragma once

#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// Fills TL, AT, AC, MC, SMR and the number of switches of the paper's section V-A.2 from a trajectory. AC and MC use
/// eq. (27) on three neighbours of one mode and one driving direction. Other three points have no curvature.
void measure(const Trajectory& trajectory, const Robot& robot, PlanMetrics& metrics);

}  // namespace fourwis
