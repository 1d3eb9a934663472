#pragma once

#include "fourwis_navigation/track/track_options.h"
#include "fourwis_navigation/track/tracker.h"
#include "stop_reason.h"

namespace fourwis
{

/// Deviation of a pose from where it should be, in the direction of travel.
struct Deviation
{
  double lateral = 0.0;       ///< to the left [m]
  double longitudinal = 0.0;  ///< forward [m]
  double heading = 0.0;       ///< [rad]
};

/// How far apart two headings are, 0 to pi [rad].
double turn_between(const Pose& a, const Pose& b);

/// Whether two poses are no farther apart than `xy` [m] and `yaw` [rad].
bool is_within(const Pose& a, const Pose& b, double xy, double yaw);

/// What is wrong with the input: numbers that are not finite, stamps that are old or in the future, a base that is not
/// enabled.
StopReason judge_input(const TrackInput& input, const TrackOptions& options);

/// The reason to stop if the robot is farther from the trajectory than it may be.
StopReason judge_deviation(const Deviation& deviation, const TrackOptions& options);

/// Notices wheels that stay away from the angles they should have.
class WheelWatch
{
public:
  explicit WheelWatch(const TrackOptions& options) : options_(options) {}

  void restart() { away_.fill(0.0); }

  /// Angles modulo pi; `period`: time since the last call [s].
  StopReason judge(const PerWheel& expected, const PerWheel& measured, double period);

private:
  const TrackOptions options_;
  PerWheel away_{};  ///< how long each wheel has been away [s]
};

/// Whether no wheel rolls faster than rest_speed.
bool is_at_rest(const WheelState& wheels, const TrackOptions& options);

}  // namespace fourwis
