#pragma once

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// Limits of (v, phi, a, omega) within a mode under which body and wheels keep theirs in every motion.
class MotionLimits
{
public:
  /// `reference_speed` bounds the speed, too. The wheels on the inside of a curve turn faster than the equivalent wheel,
  /// those on the outside roll faster than the centre; `wheel_max_rate` and `wheel_max_speed` hold for all of them.
  MotionLimits(const Robot& robot, Mode mode, double reference_speed);

  double speed;             ///< of |v| [m/s]
  double angle;             ///< of |phi| [rad]
  double acceleration;      ///< of |a| [m/s^2]
  double steering_rate;     ///< of |omega| at every phi [rad/s]
  double fastest_steering;  ///< of |omega| at a phi at which no wheel turns faster than the equivalent one [rad/s]

  /// What the optimisation allows a wheel to turn about its own axis: the limit less a reserve for rounding [rad/s].
  static double wheel_rate(const Robot& robot);
};

}  // namespace fourwis
