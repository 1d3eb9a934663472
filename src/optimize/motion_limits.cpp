#include "motion_limits.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/vehicle/mode_limits.h"
#include "fourwis_navigation/vehicle/wheels.h"

namespace fourwis
{
namespace
{

/// Reserve to the limits of the wheels, for rounding.
constexpr double kReserve = 1.0 - 1e-3;
/// Number of angles between straight and full lock at which the wheels are checked.
constexpr int kSteps = 64;

/// Greatest |d delta_i / d phi| of any wheel at phi and at -phi, by central differences.
double wheel_gain(const Robot& robot, Mode mode, double phi)
{
  constexpr double kStep = 1e-5;
  double gain = 0.0;
  for (double angle : {phi, -phi})
  {
    const WheelAngles below = wheel_angles(robot, mode, angle - kStep),
                      above = wheel_angles(robot, mode, angle + kStep);
    for (std::size_t i = 0; i < below.size(); ++i)
      gain = std::max(gain, std::abs(std::remainder(above[i] - below[i], M_PI)) / (2.0 * kStep));
  }
  return gain;
}

}  // namespace

MotionLimits::MotionLimits(const Robot& robot, Mode mode)
  : speed(std::min(robot.max_speed, wheel_speed(robot))),
    angle(DriveLimits(robot)[mode].phi),
    acceleration(robot.max_acceleration)
{
  wheels_limit_speed = speed * wheel_speed_ratio(robot, mode, angle) > wheel_speed(robot);
  double gain = 0.0;
  for (int k = 0; k <= kSteps; ++k) gain = std::max(gain, wheel_gain(robot, mode, angle * k / kSteps));
  steering_rate = std::min(robot.max_steering_rate, wheel_rate(robot) / gain);
  fastest_steering = std::min(robot.max_steering_rate, wheel_rate(robot));
}

double MotionLimits::wheel_speed(const Robot& robot)
{
  return kReserve * robot.wheel_max_speed;
}

double MotionLimits::wheel_rate(const Robot& robot)
{
  return kReserve * robot.wheel_max_rate;
}

}  // namespace fourwis
