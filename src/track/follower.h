#pragma once

#include "forecast.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/track/track_options.h"
#include "guard.h"
#include "mpc.h"
#include "observer.h"
#include "reference.h"

namespace fourwis
{

/// Follows one stretch from rest to rest. Its clock is the trajectory's, shifted so that the first command takes effect
/// at the stretch's beginning; it goes slower where the robot lags behind.
class Follower
{
public:
  Follower(const Robot& robot, const TrackOptions& options);

  /// From now on `reference`, which must outlive the drive, with the wheels' range of phi.
  void start(const Reference& reference, const SteeringRange& steering, const Measurement& now);

  struct Answer
  {
    ModeMotion command;      ///< for the wheels, their lag made up for
    StopReason stop_reason;  ///< if there is one, the command is not valid
    bool finished = false;   ///< the robot rests at the stretch's end, as near as following gets it
  };
  Answer step(const Measurement& now);

  /// Slows down for one control step along the present curve instead, from no more than the speed measured where that is
  /// known; what to command, v = 0 at last.
  ModeMotion brake(const Measurement& now);

  /// Of the last step.
  double clock() const { return clock_; }  ///< the trajectory's time at which the pose was measured [s]
  const Deviation& deviation() const { return deviation_; }
  const ModeMotion& asked() const { return asked_; }  ///< v and phi at the end of the step
  const std::vector<Pose>& prediction() const { return mpc_.prediction(); }

private:
  StopReason observe(const Measurement& now);
  void wait_for_robot(const MotionState& state, double period);
  ModeMotion rest(const Measurement& now);
  bool settles(const MotionState& state, const Measurement& now);
  ModeMotion ask(const Measurement& now, const MotionInput& input, double duration);

  const Robot robot_;
  const TrackOptions options_;
  const double period_;  ///< of control [s]
  Mpc mpc_;
  Forecast forecast_;
  WheelWatch watch_;
  const Reference* reference_ = nullptr;
  ErrorModel error_model_;
  double time_ = 0.0;     ///< the trajectory's, when the next command takes effect [s]
  double holding_ = 0.0;  ///< since the robot was left to rest at the end; negative while driving [s]
  double clock_ = 0.0;
  Deviation deviation_;
  ModeMotion asked_;
};

}  // namespace fourwis
