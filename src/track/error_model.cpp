#include "error_model.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/vehicle/kinematics.h"

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
    moves_(mode == Mode::spin ? 0.0 : 1.0),
    crabs_(mode == Mode::parallel ? 1.0 : 0.0)
{}

double ErrorModel::curvature(double phi) const
{
  return mode_ == Mode::spin ? 1.0 / spin_radius(robot_) : fourwis::curvature(robot_, mode_, phi);
}

double ErrorModel::curvature_slope(double phi) const
{
  const double tangent = std::tan(phi);
  if (mode_ == Mode::ackermann) return 2.0 / robot_.wheelbase * (1.0 + tangent * tangent);
  if (mode_ == Mode::lateral) return 2.0 / robot_.track_width * (1.0 + tangent * tangent);
  return 0.0;
}

double ErrorModel::course_rate(const ReferencePoint& reference) const
{
  return reference.state.v * curvature(reference.state.phi) + crabs_ * reference.input.omega;
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
  return mode_ == Mode::spin ? error[kHeading] * spin_radius(robot_) : error[kAlong];
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
  const double psi = error[kHeading] + crabs_ * error[kSteering];
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
  slope(kAcross, kSteering) = h * moves_ * v * crabs_;
  slope(kAcross, kAlong) = -h * turn;
  slope(kHeading, kSpeed) = h * curvature(phi);
  slope(kHeading, kSteering) = h * v * curvature_slope(phi);
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
  if (mode_ == Mode::parallel) return 1.0;
  // Velocity of an axis for v = 1, and its derivative with respect to phi, which comes from the yaw rate alone.
  const Twist twist = body_twist(robot_, mode_, 1.0, phi);
  const double slope = curvature_slope(phi);
  double greatest = 0.0;
  for (const WheelPosition& wheel : wheel_positions(robot_))
  {
    const double vx = twist.vx - twist.omega * wheel.y, vy = twist.vy + twist.omega * wheel.x;
    greatest = std::max(greatest, std::abs(slope * (vx * wheel.x + vy * wheel.y)) / (vx * vx + vy * vy));
  }
  return greatest;
}

}  // namespace fourwis
