#include "fourwis_navigation/vehicle/wheel_twist.h"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "fourwis_navigation/model/option_check.h"

namespace fourwis
{
namespace
{

constexpr int kNone = -1;
constexpr int kOffsetRounds = 3;  // each reduces the error in omega by offset / wheelbase

using WheelRows = Eigen::Matrix<double, 2, 3>;

/// How the velocity of a wheel's steering axis depends on (vx, vy, omega).
WheelRows rows_of(const std::array<WheelPosition, kWheels>& axes, int wheel)
{
  const WheelPosition axis = axes[static_cast<std::size_t>(wheel)];
  WheelRows rows;
  rows << 1.0, 0.0, -axis.y, 0.0, 1.0, axis.x;
  return rows;
}

Eigen::Matrix3d inverse_normal(const std::array<WheelPosition, kWheels>& axes, int left_out)
{
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kWheels; ++i)
    if (i != left_out) normal += rows_of(axes, i).transpose() * rows_of(axes, i);
  return normal.inverse();
}

}  // namespace

void check(const Robot& robot, const WheelTwistOptions& options)
{
  check(robot);
  check_ranges(options);
  const double most = std::min(robot.wheelbase, robot.track_width) / 4.0;
  require_in({-most, most, "m"}, "axis_offset", options.axis_offset);
}

WheelTwist::WheelTwist(const Robot& robot, const WheelTwistOptions& options)
  : options_(options),
    axes_(wheel_positions(robot))
{
  check(robot, options);
  for (int i = 0; i < kWheels; ++i) inverse_[static_cast<std::size_t>(i)] = inverse_normal(axes_, i);
  inverse_[kWheels] = inverse_normal(axes_, kNone);
}

TwistEstimate WheelTwist::estimate(const WheelMotion& wheels, const PerWheel& steering_rate) const
{
  TwistEstimate estimate = robust(axis_velocities(wheels, steering_rate, 0.0));
  if (options_.axis_offset == 0.0) return estimate;
  for (int round = 0; round < kOffsetRounds; ++round)
    estimate = robust(axis_velocities(wheels, steering_rate, estimate.twist.omega));
  return estimate;
}

WheelTwist::AxisVelocities WheelTwist::axis_velocities(const WheelMotion& wheels, const PerWheel& steering_rate,
                                                       double omega) const
{
  AxisVelocities velocities;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const double speed = wheels.speed[i] + options_.axis_offset * (omega + steering_rate[i]);
    velocities.col(static_cast<int>(i)) << speed * std::cos(wheels.angle[i]), speed * std::sin(wheels.angle[i]);
  }
  return velocities;
}

TwistEstimate WheelTwist::robust(const AxisVelocities& measured) const
{
  TwistEstimate best = solve(measured, kNone);
  if (best.residual <= options_.greatest_slip) return best;
  for (int i = 0; i < kWheels; ++i)
  {
    const TwistEstimate three = solve(measured, i);
    if (three.residual < best.residual) best = three;
  }
  return best;
}

TwistEstimate WheelTwist::solve(const AxisVelocities& measured, int left_out) const
{
  const Eigen::Matrix3d& inverse = inverse_[static_cast<std::size_t>(left_out == kNone ? kWheels : left_out)];
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (int i = 0; i < kWheels; ++i)
    if (i != left_out) right += rows_of(axes_, i).transpose() * measured.col(i);
  const Eigen::Vector3d twist = inverse * right;

  double squares = 0.0;
  for (int i = 0; i < kWheels; ++i)
    if (i != left_out) squares += (measured.col(i) - rows_of(axes_, i) * twist).squaredNorm();
  const int equations = left_out == kNone ? 2 * kWheels : 2 * (kWheels - 1);
  TwistEstimate estimate{{twist[0], twist[1], twist[2]}, std::sqrt(squares / (equations - 3)), left_out, inverse};
  const double deviation = std::max(options_.deviation, estimate.residual);
  estimate.covariance *= deviation * deviation;
  return estimate;
}

}  // namespace fourwis
