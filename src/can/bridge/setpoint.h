#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/model/wheels.h"

namespace fourwis::can
{

/// Where the wheels are told to be at the moment, on the way to where they should be: no angle turns faster, no wheel
/// accelerates harder or rolls faster than it may. The speeds of the four wheels change by one factor, so that they
/// keep their proportions.
class Setpoint
{
public:
  Setpoint(const Robot& robot, const BridgeOptions& options);

  /// At rest with the wheels where they are.
  void hold(const WheelMotion& measured);

  /// Speed zero from now on, without a ramp; angles as they are.
  void halt() { now_.speed = {}; }

  /// `duration` [s] further towards `target`.
  void approach(const WheelMotion& target, double duration);

  /// `duration` [s] of a controlled stop; angles as they are.
  void ramp_down(double duration);

  const WheelMotion& value() const { return now_; }

private:
  double max_angle_, max_rate_, max_speed_, max_acceleration_, stop_deceleration_;
  WheelMotion now_;
};

}  // namespace fourwis::can
