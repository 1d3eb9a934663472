#pragma once

#include <cstdint>

#include "fourwis_navigation/drives/axis_motion.h"
#include "fourwis_navigation/drives/power_state.h"
#include "homing.h"
#include "setpoint_generator.h"

namespace fourwis::drives
{

/// The CiA 402 half of a drive: power states, modes of operation, demands for the motor. It reads its settings from the
/// dictionary and writes its measurements into it.
class PowerStage
{
public:
  PowerStage(ObjectDictionary& dictionary, double max_velocity);

  /// To be called when the self-test is over.
  void become_ready();
  /// To be called when an object was written over the bus.
  void written(ObjectAddress address);
  /// The bus or the master is lost: reacts as 6007 says.
  void lose_connection();
  /// Transition 13.
  void fail();
  /// Shifts the measured position from now on [count].
  void shift_encoder(double counts) { shift_ += counts; }
  void set_warning(bool warning) { warning_ = warning; }

  /// Advances the time [s] with this motion of the motor. Returns whether the following error has lasted too long.
  bool advance(double dt, const AxisMotion& motor);

  PowerState state() const { return state_; }
  AxisDemand demand() const;  ///< in the motor's own counts
  void publish();             ///< writes statusword, mode and measurements into their objects

private:
  int mode() const { return static_cast<int>(dictionary_.get(object::kModeDisplay)); }
  int option(std::uint16_t index) const { return static_cast<int>(dictionary_.get(index)); }
  bool is_powered() const;
  bool is_halted() const;
  void command(std::uint16_t controlword);
  void enter(PowerState next);
  void adopt_mode();
  void move(double dt);
  double deceleration(bool quick) const;
  bool watch_following(double dt);
  std::uint16_t statusword() const;

  ObjectDictionary& dictionary_;
  SetpointGenerator setpoints_;
  Homing homing_;
  PowerState state_ = PowerState::not_ready;
  std::uint16_t controlword_ = 0;
  AxisMotion measured_;
  double shift_ = 0.0;          ///< measured - motor [count]
  double following_off_ = 0.0;  ///< how long the motor has been outside the window [s]
  bool following_error_ = false;
  bool warning_ = false;
};

}  // namespace fourwis::drives
