#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/model/wheels.h"
#include "steady.h"

namespace fourwis::can
{

/// Keeps wheels from turning while they roll and from rolling before they have turned. To another mode, or to angles
/// far from those of the moment: brakes with the angles held, waits for standstill, turns the wheels, waits until
/// they are aligned, drives.
class Interlock
{
public:
  explicit Interlock(const BridgeOptions& options);

  /// At rest, no mode yet.
  void reset(double now);

  /// What the wheels may be told now instead of `command`. `setpoint` is what they are told so far.
  WheelMotion permit(const WheelCommand& command, const WheelMotion& measured, const WheelMotion& setpoint, double now);

  /// Comes to rest, or rests, with the wheels as they are.
  bool holding() const { return phase_ == Phase::holding; }
  /// Every wheel has stayed near the command's angle long enough to drive.
  bool aligned() const { return aligned_now_; }
  /// The wheels should have come to rest, or should have been aligned, long ago.
  bool overdue() const { return overdue_; }
  /// The mode that the wheels stand for.
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
  Steady rolls_on_, late_;  ///< does not come to rest; is not aligned
  bool stands_ = false, aligned_now_ = false, overdue_ = false;
  Phase phase_ = Phase::holding;
  Mode mode_ = Mode::none;
  PerWheel commanded_{};  ///< the angles of the last command
};

}  // namespace fourwis::can
