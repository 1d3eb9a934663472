#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/model/wheels.h"
#include "steady.h"

namespace fourwis::can
{

/// Prevents that wheels turn to another mode while they roll, and that they roll before they have turned. For another
/// mode, or for angles far from the present ones, it brakes with the angles held, waits for standstill, turns the
/// wheels, waits until they are aligned, and then drives.
class Interlock
{
public:
  explicit Interlock(const BridgeOptions& options);

  /// The base is at rest and has no mode.
  void reset(double now);

  /// The motion that may be commanded now instead of `command`. `setpoint` is the motion that is commanded so far.
  WheelMotion permit(const WheelCommand& command, const WheelMotion& measured, const WheelMotion& setpoint, double now);

  /// Whether the base comes to rest, or rests, with the wheels' angles held.
  bool holding() const { return phase_ == Phase::holding; }
  /// Whether every wheel has been near the commanded angle for long enough to drive.
  bool aligned() const { return aligned_now_; }
  /// Whether the wheels have not come to rest, or have not aligned, in time.
  bool overdue() const { return overdue_; }
  /// The mode to which the wheels are turned.
  Mode mode() const { return mode_; }

private:
  enum class Phase
  {
    holding,
    turning,  ///< at rest, the wheels turn
    driving
  };

  void observe(const WheelCommand& command, const WheelMotion& measured, const WheelMotion& setpoint, double now);
  Phase next_phase(const WheelCommand& command, const WheelMotion& measured, const WheelMotion& setpoint) const;

  const double tolerance_, standstill_speed_;
  Steady standstill_, aligned_;
  Steady rolls_on_, late_;  ///< not at rest in time; not aligned in time
  bool stands_ = false, aligned_now_ = false, overdue_ = false;
  Phase phase_ = Phase::holding;
  Mode mode_ = Mode::none;
  PerWheel commanded_{};  ///< the angles of the last command
};

}  // namespace fourwis::can
