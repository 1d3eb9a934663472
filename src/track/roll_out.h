#pragma once

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"
#include "motion_state.h"

namespace fourwis
{

/// State after `duration` with constant input: one step of Simpson's rule (4th order) for the pose, v and phi are
/// linear. theta is not wrapped.
MotionState roll_out(const Robot& robot, Mode mode, const MotionState& start, const MotionInput& input,
                     double duration);

}  // namespace fourwis
