#include "rollout.h"

namespace fourwis::referee
{
namespace
{

// Over such steps the error of Simpson's rule is micrometres, far below the roll-out tolerance.
constexpr double kStepLength = 0.05;  // [m]
constexpr double kStepAngle = 0.05;   // of theta and of phi [rad]
constexpr double kMostSteps = 1.0e5;  // of one advance; enough unless limits are broken grossly

}  // namespace

Rollout::Rollout(const Robot& robot, const TrajectoryPoint& from, const TrajectoryPoint& to)
  : mode_(from.mode),
    duration_(to.t - from.t),
    x_(from.x),
    y_(from.y),
    theta_(from.theta),
    v_(from.v),
    change_of_v_(to.v - from.v),
    phi_(from.phi),
    change_of_phi_(to.phi - from.phi),
    heading_{std::cos(from.theta), std::sin(from.theta)}
{
  if (mode_ == Mode::ackermann) tangent_factor_ = 2.0 / robot.wheelbase;
  if (mode_ == Mode::lateral) tangent_factor_ = 2.0 / robot.track_width;
  held_ = change_of_phi_ == 0.0 || mode_ == Mode::parallel;
  curvature_ = mode_ == Mode::parallel ? 0.0 : tangent_factor_ * std::tan(phi_);
  last_curvature_ = curvature(1.0);
  course_ = course(heading_, 0.0);
}

void Rollout::advance(double share)
{
  const double length = greatest_speed() * duration_ * share;
  const double steps = std::ceil(std::max({1.0, length / kStepLength, length * greatest_curvature() / kStepAngle,
                                           std::abs(change_of_phi_) * share / kStepAngle}));
  const int count = static_cast<int>(std::min(steps, kMostSteps));
  for (int i = 0; i < count; ++i) step(share / count);
}

Rollout::Direction Rollout::course(Direction heading, double share) const
{
  switch (mode_)
  {
    case Mode::lateral: return {-heading.s, heading.c};
    case Mode::parallel:
    {
      const double c = std::cos(phi(share)), s = std::sin(phi(share));
      return {heading.c * c - heading.s * s, heading.s * c + heading.c * s};
    }
    default: return heading;
  }
}

void Rollout::step(double share)
{
  const double h = share * duration_, middle = elapsed_ + share / 2.0, end = elapsed_ + share;
  const double v0 = speed(elapsed_), vm = speed(middle), v1 = speed(end);
  const double curvature1 = curvature(end);
  const double turn0 = v0 * curvature_, turn_m = vm * curvature(middle), turn1 = v1 * curvature1;

  // The parabola through the three rates, integrated to the middle and to the end.
  const double theta_m = theta_ + h / 24.0 * (5.0 * turn0 + 8.0 * turn_m - turn1);
  const double theta1 = theta_ + h / 6.0 * (turn0 + 4.0 * turn_m + turn1);
  const Direction heading1 = heading(theta1);
  const Direction course_m = course(heading(theta_m), middle), course1 = course(heading1, end);

  x_ += h / 6.0 * (v0 * course_.c + 4.0 * vm * course_m.c + v1 * course1.c);
  y_ += h / 6.0 * (v0 * course_.s + 4.0 * vm * course_m.s + v1 * course1.s);
  theta_ = theta1;
  heading_ = heading1;
  course_ = course1;
  curvature_ = curvature1;
  elapsed_ = end;
}

}  // namespace fourwis::referee
