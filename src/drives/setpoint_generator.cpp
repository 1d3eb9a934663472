#include "setpoint_generator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fourwis::drives
{
namespace
{

using namespace mode_of_operation;

constexpr std::uint16_t kTargetReached = 1 << 10, kInternalLimit = 1 << 11, kModeBit12 = 1 << 12;
/// Tolerance for a profile velocity that is reached and for a motor that stands, as a share of the greatest velocity.
constexpr double kVelocityWindow = 1e-3;

/// 60C2: sub-index 1 times ten to the power of sub-index 2 [s].
double interpolation_period(const ObjectDictionary& dictionary)
{
  return static_cast<double>(dictionary.get(object::kInterpolationPeriod, 1)) *
         std::pow(10.0, static_cast<double>(dictionary.get(object::kInterpolationPeriod, 2)));
}

struct Range
{
  double low, high;
};

/// 607D; without limits while both are the same.
Range soft_limits(const ObjectDictionary& dictionary)
{
  const auto low = static_cast<double>(dictionary.get(object::kSoftLimits, 1));
  const auto high = static_cast<double>(dictionary.get(object::kSoftLimits, 2));
  const double infinite = std::numeric_limits<double>::infinity();
  return low < high ? Range{low, high} : Range{-infinite, infinite};
}

}  // namespace

void SetpointGenerator::start(const AxisMotion& measured)
{
  setpoint_ = {measured.position, measured.velocity};
  profile_.reset(measured.position);
  limited_ = false;
  target_written();
}

void SetpointGenerator::target_written()
{
  time_left_ = interpolation_period(dictionary_);
}

void SetpointGenerator::follow(double dt)
{
  const auto target_velocity = static_cast<double>(dictionary_.get(object::kTargetVelocity));
  const Range limits = soft_limits(dictionary_);
  switch (mode())
  {
    case kCyclicPosition: return follow_cyclic_position(dt);
    case kCyclicVelocity: return follow_velocity(target_velocity);
    case kProfilePosition:
      profile_.follow(setpoint_, limits.low, limits.high, dt);
      limited_ = profile_.is_limited();
      return;
    case kProfileVelocity:
    {
      const bool faster = std::abs(target_velocity) > std::abs(setpoint_.velocity);
      const auto rate = dictionary_.get(faster ? object::kProfileAcceleration : object::kProfileDeceleration);
      return follow_velocity(approach(setpoint_.velocity, target_velocity, static_cast<double>(rate) * dt));
    }
    default: brake(static_cast<double>(dictionary_.get(object::kQuickStopDeceleration)), dt);
  }
}

/// Moves at constant velocity to reach the target one interpolation period after it was written.
void SetpointGenerator::follow_cyclic_position(double dt)
{
  const Range limits = soft_limits(dictionary_);
  const auto asked = static_cast<double>(dictionary_.get(object::kTargetPosition));
  const double target = std::clamp(asked, limits.low, limits.high);
  limited_ = target != asked;
  const double before = setpoint_.position;
  setpoint_.position += (target - before) * std::min(1.0, dt / std::max(time_left_, dt));
  setpoint_.velocity = std::clamp((setpoint_.position - before) / dt, -max_velocity_, max_velocity_);
  time_left_ -= dt;
}

void SetpointGenerator::follow_velocity(double velocity)
{
  setpoint_.velocity = std::clamp(velocity, -max_velocity_, max_velocity_);
  limited_ = setpoint_.velocity != velocity;
}

void SetpointGenerator::brake(double deceleration, double dt)
{
  setpoint_.brake(deceleration, dt);
  target_written();
}

bool SetpointGenerator::demands_position() const
{
  return mode() == kCyclicPosition || mode() == kProfilePosition || mode() == kHoming;
}

AxisDemand SetpointGenerator::demand() const
{
  if (demands_position()) return {AxisDemand::Kind::position, setpoint_.position};
  return {AxisDemand::Kind::velocity, setpoint_.velocity};
}

std::uint16_t SetpointGenerator::status(const AxisMotion& measured) const
{
  std::uint16_t bits = limited_ ? kInternalLimit : 0;
  const double window = kVelocityWindow * max_velocity_;
  switch (mode())
  {
    case kCyclicPosition:
    case kCyclicVelocity: bits |= kModeBit12; break;  // the drive follows
    case kProfilePosition:
      if (profile_.reached()) bits |= kTargetReached;
      if (profile_.acknowledges()) bits |= kModeBit12;
      break;
    case kProfileVelocity:
      if (std::abs(measured.velocity - static_cast<double>(dictionary_.get(object::kTargetVelocity))) <= window)
        bits |= kTargetReached;
      if (std::abs(measured.velocity) <= window) bits |= kModeBit12;  // stands
      break;
    default: break;
  }
  return bits;
}

}  // namespace fourwis::drives
