#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/model/wheels.h"

namespace fourwis::can
{

/// Keeps the newest command and knows how old it is.
class CommandWatch
{
public:
  enum class Verdict
  {
    taken,
    overtaken,  ///< not taken: its sequence is not newer than that of the last one
    late,       ///< not taken: older than the timeout
    invalid     ///< not taken: something in it is no number, no mode, or beyond a wheel's travel
  };

  CommandWatch(const Robot& robot, const BridgeOptions& options)
    : max_angle_(robot.wheel_max_angle),
      timeout_(options.command_timeout)
  {}

  /// `made`: when the command was given [s].
  Verdict take(const WheelCommand& command, double made, double now);

  /// The last command that was taken, or a stop.
  const WheelCommand& newest() const { return newest_; }

  /// Whether there was a command and it is too old to be followed.
  bool expired(double now) const { return any_ && now - made_ > timeout_; }

  /// From now on no command counts as given. The mode of newest() becomes none and its speeds 0, its angles stay.
  void reset();

private:
  bool is_valid(const WheelCommand& command) const;

  double max_angle_, timeout_;
  bool any_ = false;
  double made_ = 0.0;  ///< when the newest command was given [s]
  WheelCommand newest_;
};

}  // namespace fourwis::can
