#pragma once

#include <string>

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// What is wrong with a trajectory, a sentence naming the point; empty if it can be driven: finite numbers, times that
/// increase, known modes, at rest at its ends and at switches, which keep the pose, within the robot's limits, and each
/// interval rolled out meets the next point within 5 mm and 0.01 rad (DESIGN.md section 3).
std::string check_trajectory(const Robot& robot, const Trajectory& trajectory);

}  // namespace fourwis
