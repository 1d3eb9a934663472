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

double spin_radius(const Robot& robot)
{
  return std::hypot(robot.wheelbase, robot.track_width) / 2.0;
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
    case Mode::spin: return {0.0, 0.0, v / spin_radius(robot)};
    default: return {};
  }
}

Arc::Arc(const Robot& robot, const Pose& start, Mode mode, double phi)
  : start_(start),
    kappa_(fourwis::curvature(robot, mode, phi)),
    cos_(std::cos(start.theta)),
    sin_(std::sin(start.theta))
{
  const double angle = course(mode, phi), c = std::cos(angle), s = std::sin(angle);
  cos_course_ = cos_ * c - sin_ * s;
  sin_course_ = sin_ * c + cos_ * s;
}

Arc::Placement Arc::at(double s) const
{
  if (kappa_ == 0.0) return {start_.x + s * cos_course_, start_.y + s * sin_course_, cos_, sin_};
  const double delta = kappa_ * s, c = std::cos(delta), sn = std::sin(delta);
  // Displacement along and across the direction of travel at the start; 1 - cos cancels for small angles.
  const bool small = std::abs(delta) < 1e-3;
  const double along = small ? s * (1.0 - delta * delta / 6.0) : sn / kappa_;
  const double across = small ? s * delta / 2.0 * (1.0 - delta * delta / 12.0) : (1.0 - c) / kappa_;
  return {start_.x + along * cos_course_ - across * sin_course_, start_.y + along * sin_course_ + across * cos_course_,
          cos_ * c - sin_ * sn, sin_ * c + cos_ * sn};
}

Pose Arc::pose(double s) const
{
  const Placement placement = at(s);
  return {placement.x, placement.y, start_.theta + kappa_ * s};
}

Pose advance(const Robot& robot, const Pose& start, Mode mode, double phi, double s)
{
  return Arc(robot, start, mode, phi).pose(s);
}

Pose move(const Pose& start, const Twist& twist, double duration)
{
  const double turn = twist.omega * duration, x = twist.vx * duration, y = twist.vy * duration;
  // sin(turn) / turn and (1 - cos(turn)) / turn, which cancel for small angles.
  const bool small = std::abs(turn) < 1e-4;
  const double along = small ? 1.0 - turn * turn / 6.0 : std::sin(turn) / turn;
  const double across = small ? turn / 2.0 : (1.0 - std::cos(turn)) / turn;
  return compose(start, {along * x - across * y, across * x + along * y, turn});
}

}  // namespace fourwis
