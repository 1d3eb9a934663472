#pragma once

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/vehicle/wheel_branches.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"
#include "mpc.h"
#include "stop_reason.h"

namespace fourwis
{

/// Turns the motion of a mode into commands for the wheels: chooses branches at rest, keeps them while moving, slows
/// all wheels down by one factor where one would be too fast.
class SteeringUnit
{
public:
  explicit SteeringUnit(const Robot& robot) : robot_(robot) {}

  /// At rest: branches for a stretch of `mode` that begins at `start` and keeps within `wanted`, nearest to the
  /// measured angles.
  StopReason choose(Mode mode, double start, const SteeringRange& wanted, const PerWheel& measured);

  /// What phi may be on the branches chosen: some more than was wanted where the wheels' travel has it.
  const SteeringRange& range() const { return range_; }

  /// Adopts angles without turning the wheels.
  void adopt(const PerWheel& angles) { last_.angle = angles; }

  /// On the branches chosen; the command before it where that is impossible.
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
