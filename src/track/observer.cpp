#include "observer.h"

#include <algorithm>
#include <cmath>

#include "guard.h"

namespace fourwis
{

StopReason Observer::observe(const TrackInput& input)
{
  const StopReason clock = advance_clock(input.now);
  const StopReason reason = judge_input(input, options_);
  measured_.usable = !reason && !clock;
  measured_.at_rest = measured_.usable && is_at_rest(input.wheels, options_);
  if (!measured_.usable) return reason ? reason : clock;
  measured_.pose = input.pose;
  measured_.pose_stamp = measured_.now - (input.now - input.pose_stamp);
  measured_.wheels = input.wheels.motion;
  measured_.wheel_stamp = measured_.now - (input.now - input.wheels.stamp);
  return {};
}

/// A step of an unusable length counts as one control step.
StopReason Observer::advance_clock(double now)
{
  const double period = last_now_ ? now - *last_now_ : 0.0;
  if (std::isfinite(now)) last_now_ = now;
  const bool regular = period >= 0.0 && period <= options_.step_timeout;
  measured_.period = regular ? period : 1.0 / options_.controller_frequency;
  measured_.now += measured_.period;
  if (regular) return {};
  return {"the clock went on by %.3f s from one control step to the next, step_timeout is %.3f s", period,
          options_.step_timeout};
}

}  // namespace fourwis
