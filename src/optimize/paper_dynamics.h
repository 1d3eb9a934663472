#pragma once

#include <Eigen/Core>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// Euler's rule for one step of a mode, paper eq. (5) to (7) and (23): x+ = x + (f(x) + B u) h with
///   f = (v cos psi, v sin psi, v K tan phi, 0, 0), psi = theta + beta + gamma phi, B u = (0, 0, 0, a, omega);
/// (K, beta, gamma) as for SimpsonDynamics.
class EulerDynamics
{
public:
  static constexpr int kStates = 5;     ///< (x, y, theta, v, phi)
  static constexpr int kVariables = 8;  ///< and (a, omega, h)
  using State = Eigen::Matrix<double, kStates, 1>;
  using Variables = Eigen::Matrix<double, kVariables, 1>;
  using Jacobian = Eigen::Matrix<double, kStates, kVariables>;
  using Hessian = Eigen::Matrix<double, kVariables, kVariables>;

  EulerDynamics(const Robot& robot, Mode mode);

  State next(const Variables& z) const;

  Jacobian jacobian(const Variables& z) const;

  /// Second derivatives of y' next().
  Hessian hessian(const Variables& z, const State& y) const;

private:
  double k_, beta_, gamma_;
};

}  // namespace fourwis
