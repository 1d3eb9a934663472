#pragma once

#include "fourwis_navigation/model/robot.h"
#include "reference.h"

namespace fourwis
{

/// How fast a trajectory's time goes: at the rate 1 as it was planned; slower while the robot brakes on its way and while it gets
/// up to speed again. At the rate 0 it rests where it is on the trajectory. Speed along the trajectory is that of the
/// plan times the rate, and changes by max_acceleration.
class Pace
{
public:
  explicit Pace(const Robot& robot) : most_acceleration_(robot.max_acceleration) {}

  /// At the rate 1, at time t of the trajectory [s].
  void restart(double t)
  {
    time_ = t;
    rate_ = 1.0;
  }

  double time() const { return time_; }
  double rate() const { return rate_; }

  /// Lets the clock wait [s].
  void wait(double time) { time_ -= time; }

  /// Goes on for `duration` [s], `go`: towards the rate 1, otherwise towards 0.
  void advance(const Reference& reference, bool go, double duration);

  /// Where the robot is then, at the speed of the pace.
  MotionState state(const Reference& reference) const;

  /// The trajectory's time at which the robot rests if it goes on for `duration` [s] and brakes then, but at most `limit`.
  double rest_time(const Reference& reference, double duration, double limit) const;

private:
  double most_acceleration_;  ///< [m/s^2]
  double time_ = 0.0, rate_ = 1.0;
};

}  // namespace fourwis
