#pragma once

#include <string>

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// What is wrong with a trajectory: a sentence that names the point. Empty if the trajectory can be driven. Then its
/// numbers are finite, its times increase and its modes are known. It is at rest at its ends and at switches, and a
/// switch keeps the pose. It is within the robot's limits. The motion rolled out from each point meets the next one
/// within 5 mm and 0.01 rad (doc/design.md, "The meaning of a trajectory").
std::string check_trajectory(const Robot& robot, const Trajectory& trajectory);

}  // namespace fourwis
