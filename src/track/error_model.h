#pragma once

#include <Eigen/Core>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"
#include "motion_state.h"
#include "reference.h"

namespace fourwis
{

/// Deviation from the reference: (along, across, heading, speed, steering) [m, m, rad, m/s, rad]. The first two are
/// along the reference's course psi_r and to the left of it.
using ErrorState = Eigen::Matrix<double, 5, 1>;
/// Deviation of (a, omega) from the reference's.
using ErrorInput = Eigen::Matrix<double, 2, 1>;

/// The kinematics of a mode, paper eq. (2) to (7), written as the deviation from a reference that keeps to them. With
/// the curvature kappa(phi) and course psi = theta + beta + gamma phi of the mode:
///   along'   = v cos(psi - psi_r) - v_r + psi_r' across,   across' = v sin(psi - psi_r) - psi_r' along,
///   heading' = v kappa(phi) - v_r kappa(phi_r),            speed' = a - a_r,   steering' = omega - omega_r.
/// In spin the robot does not move, so the first two have no terms with v.
class ErrorModel
{
public:
  ErrorModel(const Robot& robot, Mode mode);

  Mode mode() const { return mode_; }

  /// Deviation of `state`.
  ErrorState error(const MotionState& state, const MotionState& reference) const;

  /// How far the robot is ahead of the reference: along the course, or in spin by the way of the wheels [m].
  double advance(const ErrorState& error) const;

  /// The inverse of error(): the pose with that deviation. theta is not wrapped.
  Pose pose(const ErrorState& error, const MotionState& reference) const;

  /// d(error)/dt, as above.
  ErrorState rate(const ErrorState& error, const ErrorInput& input, const ReferencePoint& reference) const;

  /// error(t + h) = jacobian (error(t), input), to first order in both about 0 and to third order in h, given the
  /// reference in the middle of the interval.
  Eigen::Matrix<double, 5, 7> jacobian(const ReferencePoint& middle, double h) const;

  /// Greatest |d(wheel angle)/d(phi)| of the four wheels.
  double steering_gain(double phi) const;

private:
  double curvature(double phi) const;
  double course_rate(const ReferencePoint& reference) const;

  Robot robot_;
  Mode mode_;
  double moves_;        ///< 1 if C, the centre of the wheels, moves, otherwise 0
  double course_gain_;  ///< gamma: 1 where the course follows phi, otherwise 0
};

}  // namespace fourwis
