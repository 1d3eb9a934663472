#pragma once

#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// A simple trajectory exactly along a path, feasible by construction. On each piece it accelerates and brakes fully, up to
/// what robot and wheels can do. It stops wherever steering, direction or mode change, as long as the wheels need to turn.
/// Empty for a path without pieces.
Trajectory stop_and_steer(const Path& path, const Robot& robot);

/// Least time in which phi can change from one angle to another at a constant rate within a mode [s]. Three things
/// limit it: the rate of phi, the rate of each wheel where it turns fastest, and wheels that have to turn the other way
/// because of their travel.
double steering_time(const Robot& robot, Mode mode, double from, double to);

}  // namespace fourwis
