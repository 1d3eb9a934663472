#include "fourwis_navigation/vehicle/wheels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{
namespace
{

/// Least turn from one angle modulo pi to another of a wheel that turns within +- travel. If one of the angles lies
/// beyond the travel, the travel is ignored.
double least_turn(double from, double to, double travel)
{
  const double shortest = std::abs(std::remainder(to - from, M_PI)), rounding = 1e-9;
  const auto lowest = [&](double angle) { return angle + std::ceil((-travel - rounding - angle) / M_PI) * M_PI; };
  double least = std::numeric_limits<double>::infinity();
  for (double a = lowest(from); a <= travel + rounding; a += M_PI)
    for (double b = lowest(to); b <= travel + rounding; b += M_PI) least = std::min(least, std::abs(b - a));
  return std::isfinite(least) ? least : shortest;
}

}  // namespace

WheelAngles wheel_angles(const Robot& robot, Mode mode, double phi)
{
  const Twist twist = body_twist(robot, mode, 1.0, phi);
  const auto positions = wheel_positions(robot);
  WheelAngles angles{};
  for (std::size_t i = 0; i < angles.size(); ++i)
    angles[i] = std::atan2(twist.vy + twist.omega * positions[i].x, twist.vx - twist.omega * positions[i].y);
  return angles;
}

double wheel_speed_ratio(const Robot& robot, Mode mode, double phi)
{
  const Twist twist = body_twist(robot, mode, 1.0, phi);
  double greatest = 0.0;
  for (const WheelPosition& wheel : wheel_positions(robot))
    greatest = std::max(greatest, std::hypot(twist.vy + twist.omega * wheel.x, twist.vx - twist.omega * wheel.y));
  return greatest;
}

double reorientation_time(const Robot& robot, const WheelAngles& from, const WheelAngles& to)
{
  double greatest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i)
    greatest = std::max(greatest, least_turn(from[i], to[i], robot.wheel_max_angle));
  return greatest / robot.wheel_max_rate;
}

}  // namespace fourwis
