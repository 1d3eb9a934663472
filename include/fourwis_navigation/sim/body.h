#pragma once

#include <array>

#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/sim/simulator_options.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{

/// Which wheels are driven. A wheel that is not driven rolls freely and only keeps the body from moving sideways.
using DrivenWheels = std::array<bool, kWheels>;

/// A body without mass on four wheels. Its twist is the least-squares fit to the velocities of the wheels along and
/// across their headings. The twist is integrated on exact arcs.
class Body
{
public:
  /// Throws as check() does.
  Body(const Robot& robot, const SlipOptions& slip);

  /// Places the body at a pose, at rest.
  void place(const Pose& pose);

  /// Moves for `duration` [s], in which the motion of the wheels is taken as constant.
  void step(double duration, const WheelMotion& wheels, const DrivenWheels& driven);

  const Pose& pose() const { return pose_; }     ///< theta is not wrapped
  const Twist& twist() const { return twist_; }  ///< in the body's frame

  /// The rolling speed of a wheel at this angle when it is not driven [m/s].
  double rolling_speed(int wheel, double angle) const;

private:
  Twist fit(const WheelMotion& wheels, const DrivenWheels& driven) const;

  std::array<WheelPosition, kWheels> axes_;
  SlipOptions slip_;
  Pose pose_;
  Twist twist_;
};

}  // namespace fourwis
