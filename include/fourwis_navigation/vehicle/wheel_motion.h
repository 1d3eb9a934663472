#pragma once

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/wheels.h"

namespace fourwis
{

/// What the wheels do in a mode at speed v [m/s] and equivalent steering angle phi [rad]: the angles of wheel_angles()
/// and the signed rolling speeds that go with them. In spin v is the rolling speed of each wheel, > 0 to the left.
/// Angles depend on phi alone, so that they are known at rest; zero for Mode::none.
WheelMotion wheel_motion(const Robot& robot, Mode mode, double v, double phi);

/// A motion of the equivalent wheel.
struct ModeMotion
{
  double v = 0.0;    ///< signed speed of the centre of the wheels; in spin of each wheel [m/s]
  double phi = 0.0;  ///< equivalent steering angle [rad]
};

/// The inverse. Each wheel may use (angle, speed) or (angle + pi, -speed). phi is found by least squares over the
/// directions in which the wheels do not slip, then v by least squares over the rolling speeds. Ackermann and lateral:
/// |phi| < pi/2. Parallel: of phi + k pi, which are the same motion with (-1)^k v, the one nearest to `near_phi`. Spin:
/// phi is 0. Mode::none: both are 0.
ModeMotion mode_motion(const Robot& robot, Mode mode, const WheelMotion& wheels, double near_phi = 0.0);

/// Slows all wheels down by one factor so that none is faster than `max_speed`: the body keeps its path. Returns the
/// factor; 1 if all wheels were slow enough.
double limit_speeds(WheelMotion& wheels, double max_speed);

}  // namespace fourwis
