#include "fourwis_navigation/vehicle/wheels.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{

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
    greatest = std::max(greatest, std::abs(std::remainder(to[i] - from[i], M_PI)));
  return greatest / robot.wheel_max_rate;
}

}  // namespace fourwis
