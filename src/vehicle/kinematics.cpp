#include "fourwis_navigation/vehicle/kinematics.h"

#include <cmath>

#include "fourwis_navigation/vehicle/mode_traits.h"

namespace fourwis
{

double curvature(const Robot& robot, Mode mode, double phi)
{
  const ModeTraits& traits = traits_of(mode);
  if (traits.turns_with_phi()) return 2.0 * std::tan(phi) / (robot.*traits.base);
  return traits.turns_in_place ? 1.0 / spin_radius(robot) : 0.0;
}

double curvature_slope(const Robot& robot, Mode mode, double phi)
{
  const double tangent = std::tan(phi);
  return curvature_gain(robot, mode) * (1.0 + tangent * tangent);
}

double spin_radius(const Robot& robot)
{
  return std::hypot(robot.wheelbase, robot.track_width) / 2.0;
}

double max_curvature(const Robot& robot, Mode mode)
{
  return curvature(robot, mode, robot.max_steering_angle);
}

double turning_radius(const Robot& robot, Mode mode, double phi)
{
  return traits_of(mode).translates ? 1.0 / std::abs(curvature(robot, mode, phi)) : 0.0;
}

double course(Mode mode, double phi)
{
  const ModeTraits& traits = traits_of(mode);
  return traits.follows_phi ? phi : traits.course.angle;
}

Twist body_twist(const Robot& robot, Mode mode, double v, double phi)
{
  const ModeTraits& traits = traits_of(mode);
  const double omega = v * curvature(robot, mode, phi);
  if (!traits.translates) return {0.0, 0.0, omega};
  if (traits.follows_phi) return {v * std::cos(phi), v * std::sin(phi), omega};
  return {v * traits.course.cosine, v * traits.course.sine, omega};
}

Arc::Arc(const Robot& robot, const Pose& start, Mode mode, double phi)
  : start_(start),
    kappa_(fourwis::curvature(robot, mode, phi)),
    cos_(std::cos(start.theta)),
    sin_(std::sin(start.theta)),
    cos_course_(0.0),
    sin_course_(0.0)
{
  if (!traits_of(mode).translates) return;
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
