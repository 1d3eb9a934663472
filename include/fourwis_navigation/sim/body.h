#pragma once

#include <array>

#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/sim/simulator_options.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{

/// A wheel that its drive turns, or one that rolls along and only keeps the body from moving sideways.
using DrivenWheels = std::array<bool, kWheels>;

/// A body without mass on four wheels: its twist is the one that fits best, in the sense of least squares, to what the
/// wheels do along and across their headings; it is integrated on exact arcs.
class Body
{
public:
  /// Throws std::invalid_argument naming the option, its value and the range.
  Body(const Robot& robot, const SlipOptions& slip);

  /// Puts it there, at rest.
  void place(const Pose& pose);

  /// Moves for `duration` [s], short enough for the wheels to be constant meanwhile.
  void step(double duration, const WheelMotion& wheels, const DrivenWheels& driven);

  const Pose& pose() const { return pose_; }     ///< theta is not wrapped
  const Twist& twist() const { return twist_; }  ///< in the body's frame

  /// How fast a wheel with this angle rolls when it is not driven [m/s].
  double rolling_speed(int wheel, double angle) const;

private:
  Twist fit(const WheelMotion& wheels, const DrivenWheels& driven) const;

  std::array<WheelPosition, kWheels> axes_;
  SlipOptions slip_;
  Pose pose_;
  Twist twist_;
};

}  // namespace fourwis
