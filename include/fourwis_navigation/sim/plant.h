#pragma once

#include <array>
#include <vector>

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/sim/actuator.h"
#include "fourwis_navigation/sim/body.h"
#include "fourwis_navigation/sim/simulator_options.h"

namespace fourwis
{

/// The mechanics of the base: eight actuators and the body on the wheels. The electronics that control it set the
/// targets and switch the power of each axis.
class Plant
{
public:
  /// Throws as check() does.
  Plant(const Robot& robot, const ActuatorOptions& actuators, const SlipOptions& slip);

  /// Places the body at a pose, at rest. The wheels keep their angles.
  void place(const Pose& pose);

  /// Sets the target of a wheel, in wheel order [rad] or [m/s]. A target beyond a limit becomes the limit.
  void set_steering_target(int wheel, double angle) { at(wheel).steering.set_target(angle); }
  void set_drive_target(int wheel, double speed) { at(wheel).drive.set_target(speed); }

  /// Switches the power of an axis. Without power a steering axis keeps its angle, and a wheel rolls freely.
  void power_steering(int wheel, bool on) { at(wheel).steered = on; }
  void power_drive(int wheel, bool on) { at(wheel).driven = on; }

  /// Advances the time by a short duration [s].
  void step(double duration);

  double angle(int wheel) const { return at(wheel).steering.value(); }  ///< [rad]
  double speed(int wheel) const { return at(wheel).drive.value(); }     ///< rolling [m/s]
  WheelMotion wheels() const;
  const Body& body() const { return body_; }

private:
  struct Wheel
  {
    Actuator steering, drive;
    bool steered = true, driven = true;
  };
  Wheel& at(int wheel) { return wheels_[static_cast<std::size_t>(wheel)]; }
  const Wheel& at(int wheel) const { return wheels_[static_cast<std::size_t>(wheel)]; }

  std::vector<Wheel> wheels_;
  Body body_;
};

}  // namespace fourwis
