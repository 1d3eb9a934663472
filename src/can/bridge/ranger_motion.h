#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/can/protocol/ranger.h"

namespace fourwis::can
{

/// Between the four wheels and the few motions that a Ranger knows.
class RangerKinematics
{
public:
  RangerKinematics(const Robot& robot, const RangerOptions& options) : robot_(robot), options_(options) {}

  /// Why the base cannot do that, in words; null if it can.
  const char* refusal(const WheelCommand& command) const;

  /// The number of the base's own mode for ours.
  RangerMode base_mode(Mode mode) const;

  /// What the base has to be told so that the wheels do this, in a mode that is not refused. In parallel mode half a
  /// turn of all wheels and the opposite speed are the same: the steering nearest to `near_steering`.
  RangerMotion base_motion(Mode mode, const WheelMotion& wheels, double near_steering = 0.0) const;

  /// What the base says of its wheels, in our order, each on the branch nearest to the angle it was told to have.
  WheelMotion measured(const PerWheel& angles, const PerWheel& speeds, const PerWheel& told) const;

private:
  double inner_angle(Mode mode, double phi) const;

  Robot robot_;
  RangerOptions options_;
};

}  // namespace fourwis::can
