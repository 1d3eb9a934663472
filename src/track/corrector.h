#pragma once

#include "fourwis_navigation/track/track_options.h"
#include "reference.h"

namespace fourwis
{

/// Where the robot should rest, and within which tolerances.
struct RestTarget
{
  Pose pose;
  double xy_tolerance, yaw_tolerance;  ///< [m], [rad]

  bool is_reached(const Pose& at) const;
};

/// Creeping motions from where the robot rests to where it should rest. First it turns in place, then it moves straight
/// to the place. A correction begins only near the place, because the space in between has not been checked for
/// obstacles. Allocates nothing after set-up.
class Corrector
{
public:
  Corrector(const Robot& robot, const TrackOptions& options);

  /// Whether a correction is being driven, and its stretch.
  bool is_active() const { return active_; }
  const Reference& stretch() const { return stretch_; }

  /// Whether `at` is near enough to be corrected.
  bool is_near(const Pose& at, const RestTarget& to) const;

  /// Begins the next motion; false when correction_timeout is over.
  bool start(const Pose& from, const RestTarget& to);

  /// Lets time pass [s].
  void pass(double time) { spent_ += active_ ? time : 0.0; }

  /// The place is reached, or given up.
  void finish();

private:
  const Robot robot_;
  const TrackOptions options_;
  Reference stretch_;
  bool active_ = false;
  double spent_ = 0.0;  ///< at this place [s]
};

}  // namespace fourwis
