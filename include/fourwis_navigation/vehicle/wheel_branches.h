#pragma once

#include <optional>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/wheels.h"

namespace fourwis
{

// A wheel rolls the same way at (angle, speed) and at (angle + k pi, (-1)^k speed). Which of these branches within
// +- Robot::wheel_max_angle a wheel is on is chosen at standstill, for everything up to the next standstill in another
// mode, and kept while moving: a wheel that changes its branch has to turn by 180 degrees.

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
  double angle = 0.0;  ///< where the branch that misses least would have to go [rad]
};

/// The same motion on branches of choice, or the first wheel that cannot.
struct BranchedMotion
{
  WheelMotion motion;
  std::optional<BeyondTravel> beyond;  ///< empty when `motion` is valid
};

/// At standstill: the angles at the start of the stretch, speed 0, each on the branch that stays within the travel for
/// the whole stretch and is nearest to the measured angle.
BranchedMotion choose_branches(const Robot& robot, const SteeringStretch& stretch, const PerWheel& measured);

/// While moving: `motion` with each wheel on the branch nearest to the angle it was last told to have, within its
/// travel or not at all.
BranchedMotion continue_branches(const Robot& robot, const WheelMotion& motion, const PerWheel& previous);

}  // namespace fourwis
