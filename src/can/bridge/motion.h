#pragma once

#include "command_watch.h"
#include "interlock.h"
#include "setpoint.h"

namespace fourwis::can
{

/// From commands to what the wheels are told at the moment.
class Motion
{
public:
  Motion(const Robot& robot, const BridgeOptions& options);

  /// The base is going to follow; there is no command and no mode yet.
  void begin(double now);

  /// Whatever was commanded is not followed any more.
  void forget() { commands_.forget(); }

  /// The wheels are told to be where they are, at rest.
  void hold(const WheelMotion& measured, double now);

  CommandWatch::Verdict take(const WheelCommand& command, double made, double now)
  {
    return commands_.take(command, made, now);
  }

  /// Nearer to the newest command.
  void follow(const WheelMotion& measured, double now);

  /// Without commands: rolls out with the angles held, or is told to stand at once.
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
  double moved_ = 0.0;  ///< when the set-point was last changed
};

}  // namespace fourwis::can
