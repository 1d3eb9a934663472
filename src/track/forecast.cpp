#include "forecast.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "roll_out.h"

namespace fourwis
{
namespace
{

/// A lag shorter than this counts as none [s].
constexpr double kLeastLag = 1e-3;
/// Step of the roll-out [s].
constexpr double kStep = 0.01;

double faded(double deviation, double time, double lag)
{
  return deviation * std::exp(-std::max(0.0, time) / std::max(lag, kLeastLag));
}

}  // namespace

Forecast::Forecast(const Robot& robot, const TrackOptions& options)
  : robot_(robot),
    drive_lag_(options.drive_lag),
    steering_lag_(options.steering_lag)
{
  restart(Mode::none, 0.0);
}

void Forecast::restart(Mode mode, double phi)
{
  mode_ = mode;
  asked_.fill({-std::numeric_limits<double>::infinity(), {0.0, phi}});
  deviation_ = {};
}

void Forecast::ask(double t, const ModeMotion& next, double duration)
{
  const ModeMotion now = asked(t);
  for (const Knot& knot : {Knot{t, now}, Knot{t + duration, next}})
  {
    // A command may come before the last one has taken effect.
    for (std::size_t n = 0; n < kMemory && asked_[newest_].t > knot.t; ++n) newest_ = (newest_ + kMemory - 1) % kMemory;
    newest_ = (newest_ + 1) % kMemory;
    asked_[newest_] = knot;
  }
}

ModeMotion Forecast::asked(double t) const
{
  std::size_t after = newest_;
  if (t >= asked_[after].t) return asked_[after].motion;
  for (std::size_t n = 0; n + 2 < kMemory; ++n)
  {
    const std::size_t before = (after + kMemory - 1) % kMemory;
    const Knot &a = asked_[before], &b = asked_[after];
    if (t >= a.t)
    {
      const double share = std::isfinite(a.t) && b.t > a.t ? (t - a.t) / (b.t - a.t) : 0.0;
      return {a.motion.v + share * (b.motion.v - a.motion.v), a.motion.phi + share * (b.motion.phi - a.motion.phi)};
    }
    after = before;
  }
  return asked_[after].motion;
}

void Forecast::measured(double t, const ModeMotion& motion)
{
  const ModeMotion wanted = asked(t);
  deviation_ = {t, {motion.v - wanted.v, motion.phi - wanted.phi}};
}

ModeMotion Forecast::expected(double t) const
{
  ModeMotion motion = asked(t);
  motion.v += faded(deviation_.motion.v, t - deviation_.t, drive_lag_);
  motion.phi += faded(deviation_.motion.phi, t - deviation_.t, steering_lag_);
  return motion;
}

MotionState Forecast::ahead(const Pose& pose, double stamp, double until) const
{
  const int steps = static_cast<int>(std::ceil(std::max(0.0, until - stamp) / kStep));
  const double h = steps > 0 ? (until - stamp) / steps : 0.0;
  MotionState state = {pose};
  ModeMotion motion = expected(stamp);
  for (int i = 1; i <= steps; ++i)
  {
    const ModeMotion next = expected(stamp + i * h);
    const MotionInput input = {(next.v - motion.v) / h, (next.phi - motion.phi) / h};
    state = roll_out(robot_, mode_, {state.pose, motion.v, motion.phi}, input, h);
    motion = next;
  }
  const ModeMotion end = asked(until);
  return {state.pose, end.v, end.phi};
}

}  // namespace fourwis
