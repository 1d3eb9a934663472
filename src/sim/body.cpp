#include "fourwis_navigation/sim/body.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "fourwis_navigation/model/option_check.h"

namespace fourwis
{
namespace
{

/// Weight of the rolling resistance of a wheel that is not driven. It is too small to slow the driven wheels down, but
/// a body without any drive stands still.
constexpr double kResistance = 1e-9;

/// The derivative of a wheel's velocity in the direction `angle` with respect to (vx, vy, omega).
Eigen::Vector3d row(const WheelPosition& axis, double angle)
{
  const double c = std::cos(angle), s = std::sin(angle);
  return {c, s, s * axis.x - c * axis.y};
}

}  // namespace

Body::Body(const Robot& robot, const SlipOptions& slip) : axes_(wheel_positions(checked(robot))), slip_(checked(slip))
{}

void Body::place(const Pose& pose)
{
  pose_ = pose;
  twist_ = {};
}

void Body::step(double duration, const WheelMotion& wheels, const DrivenWheels& driven)
{
  twist_ = fit(wheels, driven);
  pose_ = move(pose_, twist_, duration);
}

double Body::rolling_speed(int wheel, double angle) const
{
  return row(axes_[static_cast<std::size_t>(wheel)], angle).dot(Eigen::Vector3d(twist_.vx, twist_.vy, twist_.omega));
}

Twist Body::fit(const WheelMotion& wheels, const DrivenWheels& driven) const
{
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const double outward = -slip_.lateral_slip * std::abs(wheels.speed[i]) * twist_.omega;
    const double course = wheels.angle[i] + outward;
    const Eigen::Vector3d along = row(axes_[i], course), across = row(axes_[i], course + M_PI_2);
    normal += (driven[i] ? 1.0 : kResistance) * along * along.transpose() + across * across.transpose();
    if (driven[i]) right += (1.0 - slip_.drive_slip) * wheels.speed[i] * along;
  }
  const Eigen::Vector3d twist = normal.ldlt().solve(right);
  return {twist[0], twist[1], twist[2]};
}

}  // namespace fourwis
