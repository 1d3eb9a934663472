#include "position_profile.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fourwis::drives
{
namespace
{

constexpr std::uint16_t kNewSetpoint = 0x10, kImmediately = 0x20, kRelative = 0x40;

/// The greatest speed from which `deceleration` in steps of dt comes to rest within `distance`:
/// v^2 / (2 a) + v dt / 2 = distance.
double braking_speed(double distance, double deceleration, double dt)
{
  const double step = 0.5 * deceleration * dt;
  return std::sqrt(step * step + 2.0 * deceleration * distance) - step;
}

}  // namespace

double approach(double value, double target, double step)
{
  return value + std::clamp(target - value, -step, step);
}

void PositionProfile::reset(double position)
{
  target_ = position;
  next_.reset();
  handed_over_ = acknowledge_ = limited_ = false;
  reached_ = true;
}

void PositionProfile::command(std::uint16_t controlword, std::uint16_t previous)
{
  handed_over_ = (controlword & kNewSetpoint) != 0;
  const bool rising = handed_over_ && (previous & kNewSetpoint) == 0;
  if (rising && !next_)
  {
    const auto asked = static_cast<double>(dictionary_.get(object::kTargetPosition));
    const double target = (controlword & kRelative) != 0 ? target_ + asked : asked;
    if ((controlword & kImmediately) != 0 || reached_)
      take(target);
    else
      next_ = target;
    acknowledge_ = true;
  }
  if (!handed_over_ && !next_) acknowledge_ = false;
}

void PositionProfile::take(double target)
{
  target_ = target;
  reached_ = false;
}

void PositionProfile::follow(Setpoint& setpoint, double low, double high, double dt)
{
  const double target = std::clamp(target_, low, high), left = target - setpoint.position;
  limited_ = target != target_;
  const auto acceleration = static_cast<double>(dictionary_.get(object::kProfileAcceleration));
  const auto deceleration = static_cast<double>(dictionary_.get(object::kProfileDeceleration));
  const auto fastest = static_cast<double>(dictionary_.get(object::kProfileVelocity));
  const double wanted = std::copysign(std::min(fastest, braking_speed(std::abs(left), deceleration, dt)), left);
  const bool faster = std::abs(wanted) > std::abs(setpoint.velocity) && wanted * setpoint.velocity >= 0.0;
  setpoint.velocity = approach(setpoint.velocity, wanted, (faster ? acceleration : deceleration) * dt);
  const bool near = std::abs(left) <= std::max(0.5, std::abs(setpoint.velocity) * dt);
  if (!near || std::abs(setpoint.velocity) > 2.0 * deceleration * dt)
  {
    setpoint.position += setpoint.velocity * dt;
    return;
  }
  setpoint = {target, 0.0};
  reached_ = true;
  if (next_) take(*std::exchange(next_, std::nullopt));
  if (!handed_over_) acknowledge_ = false;
}

}  // namespace fourwis::drives
