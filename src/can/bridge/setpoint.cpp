#include "setpoint.h"

#include <algorithm>

#include "fourwis_navigation/vehicle/wheel_motion.h"

namespace fourwis::can
{

Setpoint::Setpoint(const Robot& robot, const BridgeOptions& options)
  : max_angle_(robot.wheel_max_angle),
    max_rate_(robot.wheel_max_rate),
    max_speed_(robot.wheel_max_speed),
    max_acceleration_(options.max_acceleration),
    stop_deceleration_(options.stop_deceleration)
{}

void Setpoint::hold(const WheelMotion& measured)
{
  now_.angle = measured.angle;
  now_.speed = {};
}

void Setpoint::approach(const WheelMotion& target, double duration)
{
  const double turn = max_rate_ * duration, change = max_acceleration_ * duration;
  WheelMotion wanted = target;
  limit_speeds(wanted, max_speed_);
  const double gap = greatest_gap(wanted.speed, now_.speed);
  const double share = gap > change ? change / gap : 1.0;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const double angle = std::clamp(wanted.angle[i], -max_angle_, max_angle_);
    now_.angle[i] += std::clamp(angle - now_.angle[i], -turn, turn);
    now_.speed[i] += share * (wanted.speed[i] - now_.speed[i]);
  }
}

void Setpoint::ramp_down(double duration)
{
  const double speed = greatest_magnitude(now_.speed), left = speed - stop_deceleration_ * duration;
  for (double& wheel : now_.speed) wheel = left > 0.0 ? wheel * left / speed : 0.0;
}

}  // namespace fourwis::can
