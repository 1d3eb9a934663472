#include "setpoint.h"

#include <algorithm>
#include <cmath>

namespace fourwis::can
{

Setpoint::Setpoint(const Robot& robot, const BridgeOptions& options)
  : max_angle_(robot.wheel_max_angle), max_rate_(robot.wheel_max_rate), max_speed_(robot.wheel_max_speed),
    max_acceleration_(options.max_acceleration), stop_deceleration_(options.stop_deceleration)
{
}

void Setpoint::hold(const WheelMotion& measured)
{
  now_.angle = measured.angle;
  now_.speed = {};
}

void Setpoint::approach(const WheelMotion& target, double duration)
{
  const double turn = max_rate_ * duration, change = max_acceleration_ * duration;
  const double scale = std::min(1.0, max_speed_ / std::max(fastest(target.speed), max_speed_));
  double share = 1.0;
  for (int i = 0; i < kWheels; ++i)
  {
    const double angle = std::clamp(target.angle[i], -max_angle_, max_angle_);
    now_.angle[i] += std::clamp(angle - now_.angle[i], -turn, turn);
    share = std::min(share, change / std::max(std::abs(scale * target.speed[i] - now_.speed[i]), change));
  }
  for (int i = 0; i < kWheels; ++i) now_.speed[i] += share * (scale * target.speed[i] - now_.speed[i]);
}

void Setpoint::ramp_down(double duration)
{
  const double speed = fastest(now_.speed), left = speed - stop_deceleration_ * duration;
  for (double& wheel : now_.speed) wheel = left > 0.0 ? wheel * left / speed : 0.0;
}

double fastest(const PerWheel& speed)
{
  double fastest = 0.0;
  for (const double wheel : speed) fastest = std::max(fastest, std::abs(wheel));
  return fastest;
}

double largest_gap(const PerWheel& a, const PerWheel& b)
{
  double gap = 0.0;
  for (int i = 0; i < kWheels; ++i) gap = std::max(gap, std::abs(a[i] - b[i]));
  return gap;
}

}  // namespace fourwis::can
