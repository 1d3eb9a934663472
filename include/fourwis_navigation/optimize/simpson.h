#pragma once

#include <Eigen/Core>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// One interval of the motion of a mode, of length h with constant a and omega, integrated by Simpson's rule (4th order):
/// with v_i = v + c_i a h, phi_i = phi + c_i omega h at c = (0, 1/2, 1), yaw rate r_i = v_i K tan(phi_i) and course
///   psi_i = theta + beta + gamma phi_i + h sum_j S_ij r_j,
/// where S integrates the parabola through r_0, r_1, r_2 from 0 to c_i,
///   x+ = x + h/6 (v_0 cos psi_0 + 4 v_1 cos psi_1 + v_2 cos psi_2),   y+ likewise with sin,
///   theta+ = theta + h/6 (r_0 + 4 r_1 + r_2),   v+ = v_2,   phi+ = phi_2.
/// (K, beta, gamma) is (2/L, 0, 0) in ackermann mode, (2/W, pi/2, 0) in lateral and (0, 0, 1) in parallel: paper eq. (5) to
/// (7). The paper's own scheme is Euler's, see doc/deviations.md.
class SimpsonDynamics
{
public:
  static constexpr int kStates = 5;    ///< (x, y, theta, v, phi)
  static constexpr int kControls = 3;  ///< (a, omega, h)
  static constexpr int kVariables = kStates + kControls;
  using State = Eigen::Matrix<double, kStates, 1>;
  using Control = Eigen::Matrix<double, kControls, 1>;
  using Jacobian = Eigen::Matrix<double, kStates, kVariables>;
  using Hessian = Eigen::Matrix<double, kVariables, kVariables>;

  SimpsonDynamics(const Robot& robot, Mode mode);

  /// State at the end of the interval.
  State next(const State& x, const Control& u) const;

  /// `jacobian` of next(), and adds the second derivatives of lambda' next() to `hessian`.
  void differentiate(const State& x, const Control& u, const State& lambda, Jacobian& jacobian, Hessian& hessian) const;

private:
  struct Nodes;
  Nodes nodes(const State& x, const Control& u) const;

  double k_, beta_, gamma_;
};

}  // namespace fourwis
