#pragma once

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// Limits of (v, phi, a, omega) within a mode under which body and wheels keep theirs, whatever the motion.
struct MotionLimits
{
  double speed;          ///< of |v| [m/s]
  double angle;          ///< of |phi| [rad]
  double acceleration;   ///< of |a| [m/s^2]
  double steering_rate;  ///< of |omega| [rad/s]
};

/// `reference_speed` bounds the speed, too. The wheels on the inside of a curve turn faster than the equivalent wheel, those on the
/// outside roll faster than the centre: where they do most, at full lock, they keep `wheel_max_rate` and
/// `wheel_max_speed`.
MotionLimits motion_limits(const Robot& robot, Mode mode, double reference_speed);

}  // namespace fourwis
