#pragma once

#include "command_watch.h"
#include "interlock.h"
#include "setpoint.h"

namespace fourwis::can
{

/// Turns commands into the set-point of the wheels.
class Motion
{
public:
  Motion(const Robot& robot, const BridgeOptions& options);

  /// The base begins to follow commands. There is no command and no mode yet.
  void begin(double now);

  /// The last command is not followed any more.
  void reset() { commands_.reset(); }

  /// The set-point is the present position of the wheels, at rest.
  void hold(const WheelMotion& measured, double now);

  CommandWatch::Verdict take(const WheelCommand& command, double made, double now)
  {
    return commands_.take(command, made, now);
  }

  /// The set-point moves towards the newest command.
  void follow(const WheelMotion& measured, double now);

  /// Without commands, with the angles held: the speed goes down by a ramp, or is 0 at once.
  void ramp_down(double now);
  void halt(double now);

  const WheelMotion& setpoint() const { return setpoint_.value(); }
  const WheelCommand& newest() const { return commands_.newest(); }
  bool is_command_expired(double now) const { return commands_.expired(now); }
  bool aligned() const { return interlock_.aligned(); }
  bool alignment_overdue() const { return interlock_.overdue(); }
  Mode mode() const { return interlock_.mode(); }

private:
  double elapsed(double now);

  CommandWatch commands_;
  Interlock interlock_;
  Setpoint setpoint_;
  double longest_step_;
  double moved_ = 0.0;  ///< when the set-point was changed last [s]
};

}  // namespace fourwis::can
