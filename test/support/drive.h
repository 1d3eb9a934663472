#pragma once

#include <array>
#include <cmath>

#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{

/// The pose after driving the signed length with constant phi, by Runge-Kutta integration of body_twist().
inline Pose drive_numerically(const Robot& robot, Pose pose, Mode mode, double phi, double length, int steps = 400)
{
  const Twist twist = body_twist(robot, mode, 1.0, phi);
  const double h = length / steps;
  const auto slope = [&](double theta) {
    return std::array<double, 2>{std::cos(theta) * twist.vx - std::sin(theta) * twist.vy,
                                 std::sin(theta) * twist.vx + std::cos(theta) * twist.vy};
  };
  for (int k = 0; k < steps; ++k)
  {
    const double turn = h * twist.omega;
    const auto begin = slope(pose.theta), middle = slope(pose.theta + turn / 2.0), end = slope(pose.theta + turn);
    pose.x += h / 6.0 * (begin[0] + 4.0 * middle[0] + end[0]);
    pose.y += h / 6.0 * (begin[1] + 4.0 * middle[1] + end[1]);
    pose.theta += turn;
  }
  return pose;
}

}  // namespace fourwis
