#pragma once

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// Limits of (v, phi, a, omega) within a mode under which body and wheels keep theirs in every motion.
class MotionLimits
{
public:
  /// The wheels on the inside of a curve turn faster than the equivalent wheel; `wheel_max_rate` holds for all of them.
  MotionLimits(const Robot& robot, Mode mode);

  double speed;             ///< of |v|, where the robot goes straight [m/s]
  bool wheels_limit_speed;  ///< whether a wheel would roll too fast somewhere at that speed
  double angle;             ///< of |phi| [rad]
  double acceleration;      ///< of |a| [m/s^2]
  double steering_rate;     ///< of |omega| at every phi [rad/s]
  double fastest_steering;  ///< of |omega| at a phi at which no wheel turns faster than the equivalent one [rad/s]

  /// What the optimisation allows a wheel to turn about its own axis: the limit less a reserve for rounding [rad/s].
  static double wheel_rate(const Robot& robot);

  /// The same for its rolling speed [m/s].
  static double wheel_speed(const Robot& robot);
};

}  // namespace fourwis
