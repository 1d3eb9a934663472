#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/model/wheels.h"

namespace fourwis::can
{

/// The commanded motion of the wheels at this moment, which approaches its target within the limits of steering rate,
/// acceleration and speed. The speeds of the four wheels change by one factor, so that they keep their proportions.
class Setpoint
{
public:
  Setpoint(const Robot& robot, const BridgeOptions& options);

  /// At rest, at the measured angles.
  void hold(const WheelMotion& measured);

  /// Speed 0 from now on, without a ramp. The angles stay.
  void halt() { now_.speed = {}; }

  /// Moves towards `target` for `duration` [s].
  void approach(const WheelMotion& target, double duration);

  /// Reduces the speed for `duration` [s] of a controlled stop. The angles stay.
  void ramp_down(double duration);

  const WheelMotion& value() const { return now_; }

private:
  double max_angle_, max_rate_, max_speed_, max_acceleration_, stop_deceleration_;
  WheelMotion now_;
};

}  // namespace fourwis::can
