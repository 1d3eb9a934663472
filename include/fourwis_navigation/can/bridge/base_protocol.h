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

/// What the drives of a base are asked for.
struct DriveDemand
{
  PowerGoal steering = PowerGoal::off, driving = PowerGoal::off;
  Mode mode = Mode::none;  ///< that the wheels stand for
  WheelMotion motion;      ///< followed by drives that are in operation and are to stay so
};

/// How far a base has got since its start.
enum class StartStep : std::uint8_t
{
  listening,    ///< silent: is somebody else commanding these drives?
  booting,      ///< waits for the drives
  identifying,  ///< asks them who they are
  configuring,  ///< sets them up
  starting,     ///< waits for their cyclic messages
  homing,       ///< the steering drives look for their zero
  started
};

/// What is known of one axis, for people.
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

/// A base with four steered and driven wheels, seen from the bus: what has to be sent for a demand, what is received
/// of its wheels, and what is wrong with it. Faults go to the log that it was made with. Time is an argument,
/// monotonic [s]. After construction nothing allocates.
class BaseProtocol
{
public:
  virtual ~BaseProtocol() = default;

  /// Starts all drives from the beginning, wherever they are. `reset_faults`: also those that are in fault.
  virtual void restart(bool reset_faults, double now, Outbox& outbox) = 0;

  /// A frame of the bus; no error frame.
  virtual void receive(const Frame& frame, double now, Outbox& outbox) = 0;

  /// Once a cycle: goes on with the start, looks for what has not come in time.
  virtual void supervise(double now, Outbox& outbox) = 0;

  /// Tells the drives what is asked of them.
  virtual void command(const DriveDemand& demand, double now, Outbox& outbox) = 0;

  /// Once a cycle, last: what ends it on the bus.
  virtual void end_cycle(double now, Outbox& outbox) = 0;

  virtual StartStep step() const = 0;
  virtual int first_able_to_move() const = 0;   ///< of the axes that have torque, also to brake; kNoAxis if none
  virtual int first_not_following() const = 0;  ///< of the axes that do not follow; kNoAxis if all follow
  bool in_operation() const { return first_not_following() == kNoAxis; }
  bool out_of_operation() const { return first_able_to_move() == kNoAxis; }

  virtual const WheelMotion& measured() const = 0;
  virtual double measured_at() const = 0;  ///< the oldest part of it; 0: not all wheels have been measured yet [s]

  /// Why the base cannot do what a valid command says, in words; null if it can.
  virtual const char* refusal(const WheelCommand& command) const = 0;

  virtual AxisReport axis(int axis) const = 0;
};

}  // namespace fourwis::can
