#pragma once

namespace fourwis::drives
{

/// The motion of a motor, in encoder counts of the drive.
struct AxisMotion
{
  double position = 0.0;  ///< [count]
  double velocity = 0.0;  ///< [count/s]
};

/// What a drive demands of its motor.
struct AxisDemand
{
  enum class Kind
  {
    off,       ///< no torque
    position,  ///< move to this position [count]
    velocity   ///< turn at this velocity [count/s]
  };
  Kind kind = Kind::off;
  double value = 0.0;
};

}  // namespace fourwis::drives
