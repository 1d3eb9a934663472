#include "fourwis_navigation/vehicle/kinematics.h"

#include <cmath>

namespace fourwis
{

double curvature(const Robot& robot, Mode mode, double phi)
{
  switch (mode)
  {
    case Mode::ackermann: return 2.0 * std::tan(phi) / robot.wheelbase;
    case Mode::lateral: return 2.0 * std::tan(phi) / robot.track_width;
    default: return 0.0;
  }
}

double max_curvature(const Robot& robot, Mode mode)
{
  return curvature(robot, mode, robot.max_steering_angle);
}

double course(Mode mode, double phi)
{
  switch (mode)
  {
    case Mode::lateral: return M_PI_2;
    case Mode::parallel: return phi;
    default: return 0.0;
  }
}

Twist body_twist(const Robot& robot, Mode mode, double v, double phi)
{
  switch (mode)
  {
    case Mode::ackermann: return {v, 0.0, v * curvature(robot, mode, phi)};
    case Mode::lateral: return {0.0, v, v * curvature(robot, mode, phi)};
    case Mode::parallel: return {v * std::cos(phi), v * std::sin(phi), 0.0};
    default: return {};
  }
}

Pose advance(const Robot& robot, const Pose& start, Mode mode, double phi, double s)
{
  // The chord of an arc of angle delta has length s sin(delta/2)/(delta/2) and leaves at half the angle.
  const double delta = s * curvature(robot, mode, phi);
  const double half = delta / 2.0;
  const double chord = std::abs(half) < 1e-4 ? s * (1.0 - half * half / 6.0) : s * std::sin(half) / half;
  const double direction = start.theta + course(mode, phi) + half;
  return {start.x + chord * std::cos(direction), start.y + chord * std::sin(direction), start.theta + delta};
}

}  // namespace fourwis
