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
/// at the beginning of the stretch. The clock goes slower if the robot lags behind.
class Follower
{
public:
  Follower(const Robot& robot, const TrackOptions& options);

  /// Begins to follow `reference`, which must outlive the drive. `steering` is the range of phi that the wheels allow.
  void start(const Reference& reference, const SteeringRange& steering, const Measurement& now);

  struct Answer
  {
    ModeMotion command;      ///< for the wheels, with their lag compensated
    StopReason stop_reason;  ///< if there is one, the command is not valid
    bool finished = false;   ///< the robot is at rest and the stretch is over
  };
  /// `go`: whether the robot may go on; if not it comes to rest on its way, and waits.
  Answer step(const Measurement& now, bool go = true);

  /// The trajectory's time at which the robot rests if it goes on in this step and is to wait after it, but at most `limit`.
  double rest_time(double limit) const { return pace_.rest_time(*reference_, period_, limit); }

  /// Instead of step(): slows down for one control step along the present curve. It begins at the measured speed if
  /// that is known and less. Returns the command; in the end its v is 0.
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
  ModeMotion come_to_rest(const Measurement& now);
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
  Pace pace_;             ///< its time is the trajectory's, when the next command takes effect
  double holding_ = 0.0;  ///< time since the speed was set to 0 at the end; negative while driving [s]
  double clock_ = 0.0;
  Deviation deviation_;
  ModeMotion asked_;
};

}  // namespace fourwis
