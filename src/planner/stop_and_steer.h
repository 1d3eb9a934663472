#pragma once

#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// The slowest honest trajectory along a path: full acceleration and braking on each piece, at most `reference_speed`, a
/// stop wherever steering, direction or mode change, and there as long as the wheels need. Feasible by construction: the
/// path is driven exactly. Empty for a path without pieces.
Trajectory stop_and_steer(const Path& path, const Robot& robot, double reference_speed);

}  // namespace fourwis
