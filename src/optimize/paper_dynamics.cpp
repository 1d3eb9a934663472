#include "paper_dynamics.h"

#include <cmath>

#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{
namespace
{

enum Index
{
  X,
  Y,
  THETA,
  V,
  PHI,
  A,
  OMEGA,
  H
};

}  // namespace

EulerDynamics::EulerDynamics(const Robot& robot, Mode mode)
  : k_(curvature(robot, mode, M_PI_4)),
    beta_(course(mode, 0.0)),
    gamma_(course(mode, 1.0) - course(mode, 0.0))
{}

EulerDynamics::State EulerDynamics::next(const Variables& z) const
{
  const double psi = z[THETA] + beta_ + gamma_ * z[PHI], ds = z[V] * z[H];
  State result = z.head<kStates>();
  result[X] += ds * std::cos(psi);
  result[Y] += ds * std::sin(psi);
  result[THETA] += ds * k_ * std::tan(z[PHI]);
  result[V] += z[A] * z[H];
  result[PHI] += z[OMEGA] * z[H];
  return result;
}

EulerDynamics::Jacobian EulerDynamics::jacobian(const Variables& z) const
{
  const double v = z[V], h = z[H];
  const double psi = z[THETA] + beta_ + gamma_ * z[PHI], c = std::cos(psi), s = std::sin(psi);
  const double tangent = std::tan(z[PHI]), slope = 1.0 + tangent * tangent;
  Jacobian j = Jacobian::Zero();
  j.leftCols<kStates>().setIdentity();
  j(X, THETA) = -h * v * s;
  j(X, V) = h * c;
  j(X, PHI) = -gamma_ * h * v * s;
  j(X, H) = v * c;
  j(Y, THETA) = h * v * c;
  j(Y, V) = h * s;
  j(Y, PHI) = gamma_ * h * v * c;
  j(Y, H) = v * s;
  j(THETA, V) = h * k_ * tangent;
  j(THETA, PHI) = h * k_ * v * slope;
  j(THETA, H) = k_ * v * tangent;
  j(V, A) = j(PHI, OMEGA) = h;
  j(V, H) = z[A];
  j(PHI, H) = z[OMEGA];
  return j;
}

EulerDynamics::Hessian EulerDynamics::hessian(const Variables& z, const State& y) const
{
  // y' next = ... + h v along + h v y_theta K tan phi + h y_v a + h y_phi omega, with d along / d psi = across.
  const double v = z[V], h = z[H];
  const double psi = z[THETA] + beta_ + gamma_ * z[PHI], c = std::cos(psi), s = std::sin(psi);
  const double along = y[X] * c + y[Y] * s, across = y[Y] * c - y[X] * s;
  const double tangent = std::tan(z[PHI]), slope = 1.0 + tangent * tangent;
  const double turn = y[THETA] * k_ * tangent, d_turn = y[THETA] * k_ * slope;
  Hessian b = Hessian::Zero();  // upper triangle
  b(THETA, THETA) = -h * v * along;
  b(THETA, V) = h * across;
  b(THETA, PHI) = -gamma_ * h * v * along;
  b(THETA, H) = v * across;
  b(V, PHI) = h * (gamma_ * across + d_turn);
  b(V, H) = along + turn;
  b(PHI, PHI) = h * v * (2.0 * tangent * d_turn - gamma_ * gamma_ * along);
  b(PHI, H) = v * (gamma_ * across + d_turn);
  b(A, H) = y[V];
  b(OMEGA, H) = y[PHI];
  return b.selfadjointView<Eigen::Upper>();
}

}  // namespace fourwis
