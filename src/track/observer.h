#pragma once

#include <optional>

#include "fourwis_navigation/track/track_options.h"
#include "fourwis_navigation/track/tracker.h"
#include "stop_reason.h"

namespace fourwis
{

/// What was measured, on the tracker's own clock, which neither jumps nor runs back.
struct Measurement
{
  double now = 0.0;         ///< [s]
  double period = 0.0;      ///< since the step before [s]
  double pose_stamp = 0.0;  ///< [s]
  Pose pose;
  double wheel_stamp = 0.0;  ///< [s]
  WheelMotion wheels;
  bool at_rest = false;  ///< no wheel rolls faster than rest_speed
  bool usable = false;   ///< otherwise all but the times is of an earlier step
};

/// Judges what is known of the robot and keeps what can be used.
class Observer
{
public:
  explicit Observer(const TrackOptions& options) : options_(options) {}

  /// Takes over the input, or says what is wrong with it.
  StopReason observe(const TrackInput& input);

  /// The clock begins at 0 again with the next observe(), so that no rounding in a drive depends on how long ago the tracker
  /// was started.
  void restart_clock() { measured_.now = 0.0; }

  const Measurement& measured() const { return measured_; }

private:
  StopReason advance_clock(double now);

  const TrackOptions options_;
  std::optional<double> last_now_;  ///< of the input
  Measurement measured_;
};

}  // namespace fourwis
