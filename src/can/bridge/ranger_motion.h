#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/can/protocol/ranger.h"

namespace fourwis::can
{

/// Converts between the motion of the four wheels and the motions that a Ranger can carry out.
class RangerKinematics
{
public:
  RangerKinematics(const Robot& robot, const RangerOptions& options) : robot_(robot), options_(options) {}

  /// Why the base cannot carry out the command, in words; null if it can.
  const char* refusal(const WheelCommand& command) const;

  /// The base's own mode for one of ours.
  RangerMode base_mode(Mode mode) const;

  /// The command for the base that gives this motion of the wheels, in a mode that is not refused. In parallel mode
  /// (angle + pi, -speed) is the same motion: the result has the steering nearest to `near_steering`.
  RangerMotion base_motion(Mode mode, const WheelMotion& wheels, double near_steering = 0.0) const;

  /// The measured motion of the wheels in our order, each on the branch (angle + k pi) nearest to the commanded angle
  /// `told`.
  WheelMotion measured(const PerWheel& angles, const PerWheel& speeds, const PerWheel& told) const;

private:
  double inner_angle(Mode mode, double phi) const;

  Robot robot_;
  RangerOptions options_;
};

}  // namespace fourwis::can
