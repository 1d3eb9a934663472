#pragma once

namespace fourwis::drives
{

/// What a motor does, at its encoder: in counts of the drive.
struct AxisMotion
{
  double position = 0.0;  ///< [count]
  double velocity = 0.0;  ///< [count/s]
};

/// What a drive asks of its motor.
struct AxisDemand
{
  enum class Kind
  {
    off,       ///< no torque
    position,  ///< be there [count]
    velocity   ///< be that fast [count/s]
  };
  Kind kind = Kind::off;
  double value = 0.0;
};

}  // namespace fourwis::drives
