#pragma once

#include <optional>

#include "fourwis_navigation/track/track_options.h"
#include "fourwis_navigation/track/tracker.h"
#include "stop_reason.h"

namespace fourwis
{

/// What was measured, in the time of the tracker's own clock. This clock neither jumps nor runs backward.
struct Measurement
{
  double now = 0.0;         ///< [s]
  double period = 0.0;      ///< since the step before [s]
  double pose_stamp = 0.0;  ///< [s]
  Pose pose;
  double wheel_stamp = 0.0;  ///< [s]
  WheelMotion wheels;
  bool at_rest = false;  ///< no wheel rolls faster than rest_speed
  bool usable = false;   ///< if false, everything but the times is from an earlier step
};

/// Judges what is known of the robot and keeps what can be used.
class Observer
{
public:
  explicit Observer(const TrackOptions& options) : options_(options) {}

  /// Takes over the input, or says what is wrong with it.
  StopReason observe(const TrackInput& input);

  /// The clock begins at 0 again with the next observe(). So the rounding in a drive does not depend on how long the
  /// tracker has been running.
  void restart_clock() { measured_.now = 0.0; }

  const Measurement& measured() const { return measured_; }

private:
  StopReason advance_clock(double now);

  const TrackOptions options_;
  std::optional<double> last_now_;  ///< of the input
  Measurement measured_;
};

}  // namespace fourwis
