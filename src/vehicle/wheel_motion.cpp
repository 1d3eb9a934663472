#include "fourwis_navigation/vehicle/wheel_motion.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/mode_traits.h"
#include "fourwis_navigation/vehicle/wheels.h"

namespace fourwis
{
namespace
{

/// How fast a wheel of this angle rolls with the twist: the velocity of its axis along its heading.
double rolling_ratio(const Twist& twist, const WheelPosition& axis, double angle)
{
  return std::cos(angle) * (twist.vx - twist.omega * axis.y) + std::sin(angle) * (twist.vy + twist.omega * axis.x);
}

/// The angle of all wheels when they are parallel, shifted by half turns to be nearest to `near_phi`.
double common_angle(const PerWheel& angles, double near_phi)
{
  double sine = 0.0, cosine = 0.0;  // of twice the angle: half turns do not change it
  for (double angle : angles)
  {
    sine += std::sin(2.0 * angle);
    cosine += std::cos(2.0 * angle);
  }
  return near_phi + std::remainder(std::atan2(sine, cosine) / 2.0 - near_phi, M_PI);
}

/// phi of a mode that turns with phi. The wheels do not slip sideways where across = curvature * along, which is linear
/// in the curvature 2 tan(phi) / base.
double turning_angle(const Robot& robot, const ModeTraits& traits, const PerWheel& angles)
{
  const double base = robot.*traits.base;
  const Course& course = traits.course;
  const auto axes = wheel_positions(robot);
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const double c = std::cos(angles[i]), s = std::sin(angles[i]);
    const double along = axes[i].x * c + axes[i].y * s, across = course.cosine * s - course.sine * c;
    product += across * along;
    square += along * along;
  }
  return std::atan2(product * base / 2.0, square);
}

double equivalent_angle(const Robot& robot, Mode mode, const PerWheel& angles, double near_phi)
{
  const ModeTraits& traits = traits_of(mode);
  if (traits.turns_with_phi()) return turning_angle(robot, traits, angles);
  return traits.follows_phi ? common_angle(angles, near_phi) : 0.0;
}

}  // namespace

WheelMotion wheel_motion(const Robot& robot, Mode mode, double v, double phi)
{
  const Twist twist = body_twist(robot, mode, 1.0, phi);
  const auto axes = wheel_positions(robot);
  WheelMotion wheels{wheel_angles(robot, mode, phi), {}};
  for (std::size_t i = 0; i < kWheels; ++i) wheels.speed[i] = v * rolling_ratio(twist, axes[i], wheels.angle[i]);
  return wheels;
}

ModeMotion mode_motion(const Robot& robot, Mode mode, const WheelMotion& wheels, double near_phi)
{
  ModeMotion motion{0.0, equivalent_angle(robot, mode, wheels.angle, near_phi)};
  const Twist twist = body_twist(robot, mode, 1.0, motion.phi);
  const auto axes = wheel_positions(robot);
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const double ratio = rolling_ratio(twist, axes[i], wheels.angle[i]);
    product += ratio * wheels.speed[i];
    square += ratio * ratio;
  }
  if (square > 0.0) motion.v = product / square;
  return motion;
}

double limit_speeds(WheelMotion& wheels, double max_speed)
{
  const double fastest = greatest_magnitude(wheels.speed);
  if (fastest <= max_speed) return 1.0;
  const double factor = max_speed / fastest;
  for (double& speed : wheels.speed) speed *= factor;
  return factor;
}

}  // namespace fourwis
