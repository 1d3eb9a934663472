#pragma once

#include <optional>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/wheels.h"

namespace fourwis
{

// A wheel rolls the same way at (angle, speed) and at (angle + k pi, (-1)^k speed). These are its branches. At
// standstill a branch within +- Robot::wheel_max_angle is chosen for each wheel, for everything up to the next
// standstill in another mode. It is kept while moving, because a wheel that changes its branch has to turn by 180
// degrees.

/// What one mode will ask of the wheels until they may choose again.
struct SteeringStretch
{
  Mode mode = Mode::none;
  double start = 0.0;            ///< phi it begins with [rad]
  double low = 0.0, high = 0.0;  ///< least and greatest phi on the way, low <= start <= high [rad]
};

/// A wheel that has no branch within its travel.
struct BeyondTravel
{
  int wheel = 0;
  double angle = 0.0;  ///< angle that the branch with the least excess would have to reach [rad]
};

/// The same motion on chosen branches, or the first wheel that has none.
struct BranchedMotion
{
  WheelMotion motion;
  std::optional<BeyondTravel> beyond;  ///< empty when `motion` is valid
};

/// To be called at standstill. Returns the angles at the start of the stretch, with speed 0. Each is on the branch
/// nearest to the measured angle among those that stay within the travel for the whole stretch.
BranchedMotion choose_branches(const Robot& robot, const SteeringStretch& stretch, const PerWheel& measured);

/// To be called while moving. Returns `motion` with each wheel on the branch nearest to the last commanded angle. If
/// this branch is beyond the travel, there is no such motion.
BranchedMotion continue_branches(const Robot& robot, const WheelMotion& motion, const PerWheel& previous);

}  // namespace fourwis
