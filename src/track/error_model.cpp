#include "error_model.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/mode_traits.h"

namespace fourwis
{
namespace
{

enum Index
{
  kAlong,
  kAcross,
  kHeading,
  kSpeed,
  kSteering,
  kA,
  kOmega
};

}  // namespace

ErrorModel::ErrorModel(const Robot& robot, Mode mode)
  : robot_(robot),
    mode_(mode),
    moves_(traits_of(mode).translates ? 1.0 : 0.0),
    course_gain_(traits_of(mode).follows_phi ? 1.0 : 0.0)
{}

double ErrorModel::curvature(double phi) const
{
  return fourwis::curvature(robot_, mode_, phi);
}

double ErrorModel::course_rate(const ReferencePoint& reference) const
{
  return reference.state.v * curvature(reference.state.phi) + course_gain_ * reference.input.omega;
}

ErrorState ErrorModel::error(const MotionState& state, const MotionState& reference) const
{
  const double psi = reference.pose.theta + course(mode_, reference.phi);
  const double dx = state.pose.x - reference.pose.x, dy = state.pose.y - reference.pose.y;
  ErrorState error;
  error << std::cos(psi) * dx + std::sin(psi) * dy, std::cos(psi) * dy - std::sin(psi) * dx,
      wrap_angle(state.pose.theta - reference.pose.theta), state.v - reference.v, state.phi - reference.phi;
  return error;
}

double ErrorModel::advance(const ErrorState& error) const
{
  return traits_of(mode_).translates ? error[kAlong] : error[kHeading] * spin_radius(robot_);
}

Pose ErrorModel::pose(const ErrorState& error, const MotionState& reference) const
{
  const double psi = reference.pose.theta + course(mode_, reference.phi), c = std::cos(psi), s = std::sin(psi);
  return {reference.pose.x + c * error[kAlong] - s * error[kAcross],
          reference.pose.y + s * error[kAlong] + c * error[kAcross], reference.pose.theta + error[kHeading]};
}

ErrorState ErrorModel::rate(const ErrorState& error, const ErrorInput& input, const ReferencePoint& reference) const
{
  const MotionState& r = reference.state;
  const double v = r.v + error[kSpeed], phi = r.phi + error[kSteering], turn = course_rate(reference);
  const double psi = error[kHeading] + course_gain_ * error[kSteering];
  ErrorState rate;
  rate << moves_ * (v * std::cos(psi) - r.v) + turn * error[kAcross], moves_ * v * std::sin(psi) - turn * error[kAlong],
      v * curvature(phi) - r.v * curvature(r.phi), input[0], input[1];
  return rate;
}

Eigen::Matrix<double, 5, 7> ErrorModel::jacobian(const ReferencePoint& middle, double h) const
{
  const double v = middle.state.v, phi = middle.state.phi, turn = course_rate(middle);
  Eigen::Matrix<double, 5, 7> slope = Eigen::Matrix<double, 5, 7>::Zero();  // d(rate)/d(error, input), times h
  slope(kAlong, kSpeed) = h * moves_;
  slope(kAlong, kAcross) = h * turn;
  slope(kAcross, kHeading) = h * moves_ * v;
  slope(kAcross, kSteering) = h * moves_ * v * course_gain_;
  slope(kAcross, kAlong) = -h * turn;
  slope(kHeading, kSpeed) = h * curvature(phi);
  slope(kHeading, kSteering) = h * v * curvature_slope(robot_, mode_, phi);
  slope(kSpeed, kA) = slope(kSteering, kOmega) = h;

  // exp([A B; 0 0] h) = 1 + M + M^2/2 + M^3/6, whose lower rows are those of the unit matrix.
  const Eigen::Matrix<double, 5, 5> A = slope.leftCols<5>();
  const Eigen::Matrix<double, 5, 7> second = A.lazyProduct(slope), third = A.lazyProduct(second);
  Eigen::Matrix<double, 5, 7> jacobian = slope + second / 2.0 + third / 6.0;
  jacobian.leftCols<5>().diagonal().array() += 1.0;
  return jacobian;
}

double ErrorModel::steering_gain(double phi) const
{
  if (traits_of(mode_).follows_phi) return 1.0;
  // Velocity of an axis for v = 1, and its derivative with respect to phi, which comes from the yaw rate alone.
  const Twist twist = body_twist(robot_, mode_, 1.0, phi);
  const double slope = curvature_slope(robot_, mode_, phi);
  double greatest = 0.0;
  for (const WheelPosition& wheel : wheel_positions(robot_))
  {
    const double vx = twist.vx - twist.omega * wheel.y, vy = twist.vy + twist.omega * wheel.x;
    greatest = std::max(greatest, std::abs(slope * (vx * wheel.x + vy * wheel.y)) / (vx * vx + vy * vy));
  }
  return greatest;
}

}  // namespace fourwis
