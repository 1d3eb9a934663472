#pragma once

#include <cstdint>
#include <limits>

#include "fourwis_navigation/can/bridge/faults.h"
#include "fourwis_navigation/can/bus/outbox.h"
#include "fourwis_navigation/can/protocol/cia301.h"
#include "fourwis_navigation/can/protocol/cia402.h"
#include "fourwis_navigation/model/wheels.h"

namespace fourwis::can
{

/// What is demanded of the drives of a base.
struct DriveDemand
{
  PowerGoal steering = PowerGoal::off, driving = PowerGoal::off;
  Mode mode = Mode::none;  ///< the mode to which the wheels are turned
  WheelMotion motion;      ///< followed by the drives that are in operation and stay in operation
};

/// How far a base has got since its start.
enum class StartStep : std::uint8_t
{
  listening,    ///< sends nothing, and looks for another master of these drives
  booting,      ///< waits for the drives
  identifying,  ///< reads their identity
  configuring,  ///< writes their settings
  starting,     ///< waits for their cyclic messages
  homing,       ///< the steering drives search their zero
  started
};

/// What is known of one axis, for diagnostics.
struct AxisReport
{
  NmtState node = NmtState::boot_up;
  DriveState drive = DriveState::unknown;
  std::uint16_t statusword = 0;
  std::uint16_t emergency = 0;                                    ///< code of the last emergency message
  double position = 0.0;                                          ///< [rad], driving: rolled since the start [m]
  double speed = 0.0;                                             ///< [rad/s or m/s]
  double voltage = std::numeric_limits<double>::quiet_NaN();      ///< of the supply; NaN where it is not known [V]
  double temperature = std::numeric_limits<double>::quiet_NaN();  ///< likewise [deg C]
};

/// The protocol of a base with four steered and driven wheels. It turns demands into frames, frames into the motion of
/// the wheels, and reports what is wrong to the log that it was constructed with. Time is an argument, monotonic [s].
/// After construction nothing allocates.
class BaseProtocol
{
public:
  virtual ~BaseProtocol() = default;

  /// Starts all drives from the beginning, from any state. `reset_faults`: also those that are in fault.
  virtual void restart(bool reset_faults, double now, Outbox& outbox) = 0;

  /// A frame of the bus; no error frame.
  virtual void receive(const Frame& frame, double now, Outbox& outbox) = 0;

  /// Once a cycle: continues the start, and checks that everything expected has come in time.
  virtual void supervise(double now, Outbox& outbox) = 0;

  /// Sends the demand to the drives.
  virtual void command(const DriveDemand& demand, double now, Outbox& outbox) = 0;

  /// Once a cycle, as the last call: puts the frames that end the cycle into the outbox.
  virtual void end_cycle(double now, Outbox& outbox) = 0;

  virtual StartStep step() const = 0;
  virtual int first_able_to_move() const = 0;   ///< first axis that has torque, to move or to brake; kNoAxis if none
  virtual int first_not_following() const = 0;  ///< first axis that does not follow its target; kNoAxis if all follow
  bool in_operation() const { return first_not_following() == kNoAxis; }
  bool out_of_operation() const { return first_able_to_move() == kNoAxis; }

  virtual const WheelMotion& measured() const = 0;
  virtual double measured_at() const = 0;  ///< time of its oldest part; 0: a wheel has not been measured yet [s]

  /// Why the base cannot carry out a valid command, in words; null if it can.
  virtual const char* refusal(const WheelCommand& command) const = 0;

  virtual AxisReport axis(int axis) const = 0;
};

}  // namespace fourwis::can
