#include "pace.h"

#include <algorithm>
#include <cmath>

namespace fourwis
{
namespace
{

/// At a lower speed the rate changes at once [m/s].
constexpr double kSlow = 0.02;
/// Of the steps in which braking is followed ahead [s].
constexpr double kStep = 0.02;

}  // namespace

/// With the rate r the speed is v r, and changes by v r' + a r^2 each second.
void Pace::advance(const Reference& reference, bool go, double duration)
{
  if (go && rate_ == 1.0)
  {
    time_ += duration;
    return;
  }
  const double before = rate_;
  const ReferencePoint point = reference.at(time_);
  const double speed = std::abs(point.state.v);
  const double gain = std::copysign(1.0, point.state.v) * point.input.a * rate_ * rate_;
  if (speed < kSlow)
    rate_ = go ? 1.0 : 0.0;
  else if (go)
    rate_ = std::min(1.0, rate_ + std::max(0.0, most_acceleration_ - gain) / speed * duration);
  else
    rate_ = std::max(0.0, rate_ - std::max(0.0, most_acceleration_ + gain) / speed * duration);
  time_ += 0.5 * (before + rate_) * duration;
}

MotionState Pace::state(const Reference& reference) const
{
  MotionState state = reference.at(time_).state;
  if (rate_ != 1.0) state.v *= rate_;
  return state;
}

double Pace::rest_time(const Reference& reference, double duration, double limit) const
{
  Pace ahead = *this;
  ahead.advance(reference, true, duration);
  while (ahead.rate_ > 0.0 && ahead.time_ < std::min(limit, reference.end_time()))
    ahead.advance(reference, false, kStep);
  return ahead.time_;
}

}  // namespace fourwis
