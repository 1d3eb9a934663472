#pragma once

#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// A simple trajectory exactly along a path, feasible by construction. On each piece it accelerates and brakes fully,
/// up to `reference_speed`. It stops wherever steering, direction or mode change, as long as the wheels need to turn.
/// Empty for a path without pieces.
Trajectory stop_and_steer(const Path& path, const Robot& robot, double reference_speed);

}  // namespace fourwis
