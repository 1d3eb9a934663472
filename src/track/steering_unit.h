#pragma once

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/vehicle/wheel_branches.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"
#include "mpc.h"
#include "stop_reason.h"

namespace fourwis
{

/// Turns the motion of a mode into commands for the wheels. At rest it chooses branches, and while moving it keeps
/// them. If one wheel would be too fast, it slows all wheels down by the same factor.
class SteeringUnit
{
public:
  explicit SteeringUnit(const Robot& robot) : robot_(robot) {}

  /// To be called at rest. Chooses the branches nearest to the measured angles for a stretch of `mode` that begins at
  /// `start` and stays within `wanted`. Returns why there are none, if so.
  StopReason choose(Mode mode, double start, const SteeringRange& wanted, const PerWheel& measured);

  /// The range of phi on the chosen branches. It is wider than was wanted as far as the wheels' travel allows.
  const SteeringRange& range() const { return range_; }

  /// Adopts angles without turning the wheels.
  void adopt(const PerWheel& angles) { last_.angle = angles; }

  /// Sets the command for a motion, on the chosen branches. If that is impossible, the command stays as it was, and the
  /// reason is returned.
  StopReason set(Mode mode, const ModeMotion& motion);

  /// The last command; without sequence.
  WheelCommand command() const { return {mode_, 0, last_}; }
  /// Stop and hold the angles.
  WheelCommand hold() const { return {Mode::none, 0, {last_.angle, {}}}; }

private:
  Robot robot_;
  Mode mode_ = Mode::none;
  SteeringRange range_{0.0, 0.0};
  WheelMotion last_;
};

}  // namespace fourwis
