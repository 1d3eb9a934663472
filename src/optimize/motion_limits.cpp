#include "fourwis_navigation/optimize/motion_limits.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/vehicle/wheels.h"

namespace fourwis
{
namespace
{

/// Kept from the limits of the wheels, for rounding and for differences that stand in for derivatives.
constexpr double kWheelReserve = 1e-3;
constexpr int kSamples = 256;

/// Greatest |d delta_i / d phi| of any wheel over the range of phi.
double greatest_wheel_gain(const Robot& robot, Mode mode, double angle)
{
  const double step = 2.0 * angle / kSamples;
  double gain = 0.0;
  WheelAngles last = wheel_angles(robot, mode, -angle);
  for (int k = 1; k <= kSamples; ++k)
  {
    const WheelAngles next = wheel_angles(robot, mode, -angle + k * step);
    for (std::size_t i = 0; i < next.size(); ++i)
      gain = std::max(gain, std::abs(std::remainder(next[i] - last[i], M_PI)) / step);
    last = next;
  }
  return gain;
}

}  // namespace

MotionLimits motion_limits(const Robot& robot, Mode mode, double reference_speed)
{
  const double angle = mode == Mode::parallel ? robot.wheel_max_angle : robot.max_steering_angle;
  const double speed_ratio = wheel_speed_ratio(robot, mode, angle);
  // Differences over a small step fall short of the derivative at the end of the range by less than this.
  const double gain = (1.0 + 4.0 / kSamples) * greatest_wheel_gain(robot, mode, angle);
  const double reserve = 1.0 - kWheelReserve;
  return {std::min({robot.max_speed, reference_speed, reserve * robot.wheel_max_speed / speed_ratio}), angle,
          robot.max_acceleration, std::min(robot.max_steering_rate, reserve * robot.wheel_max_rate / gain)};
}

}  // namespace fourwis
