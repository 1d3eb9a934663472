#include "motion.h"

#include <algorithm>

namespace fourwis::can
{
namespace
{

/// The set-point moves on by at most this many cycles at once, also after a longer pause.
constexpr double kLongestStep = 2.0;

}  // namespace

Motion::Motion(const Robot& robot, const BridgeOptions& options)
  : commands_(robot, options),
    interlock_(options),
    setpoint_(robot, options),
    longest_step_(kLongestStep * options.cycle_time)
{}

void Motion::begin(double now)
{
  commands_.reset();
  interlock_.reset(now);
}

void Motion::hold(const WheelMotion& measured, double now)
{
  moved_ = now;
  setpoint_.hold(measured);
}

void Motion::follow(const WheelMotion& measured, double now)
{
  const double duration = elapsed(now);
  const WheelMotion target = interlock_.permit(commands_.newest(), measured, setpoint_.value(), now);
  if (interlock_.holding())
    setpoint_.ramp_down(duration);
  else
    setpoint_.approach(target, duration);
}

void Motion::ramp_down(double now)
{
  setpoint_.ramp_down(elapsed(now));
}

void Motion::halt(double now)
{
  moved_ = now;
  setpoint_.halt();
}

double Motion::elapsed(double now)
{
  const double duration = std::clamp(now - moved_, 0.0, longest_step_);
  moved_ = now;
  return duration;
}

}  // namespace fourwis::can
