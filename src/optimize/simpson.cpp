#include "fourwis_navigation/optimize/simpson.h"

#include <array>
#include <cmath>

#include "fourwis_navigation/vehicle/mode_traits.h"

namespace fourwis
{
namespace
{

constexpr std::size_t kNodes = 3;
constexpr std::array<double, kNodes> kTime = {0.0, 0.5, 1.0};                ///< c
constexpr std::array<double, kNodes> kWeight = {1.0 / 6, 4.0 / 6, 1.0 / 6};  ///< Simpson's
constexpr std::array<std::array<double, kNodes>, kNodes> kPartial = {
    {{0.0, 0.0, 0.0}, {5.0 / 24, 8.0 / 24, -1.0 / 24}, {1.0 / 6, 4.0 / 6, 1.0 / 6}}};  ///< S

/// Everything but x and y, which enter linearly: (theta, v, phi, a, omega, h).
using Variables = Eigen::Matrix<double, 6, 1>;
using Square = Eigen::Matrix<double, 6, 6>;
enum Index
{
  kTheta,
  kV,
  kPhi,
  kA,
  kOmega,
  kH
};

/// a b' + b a'
Square symmetric(const Variables& a, const Variables& b)
{
  return a * b.transpose() + b * a.transpose();
}

/// s times the second derivatives of v_i or phi_i, whose only product is of `rate` and h.
void add_product(Square& hessian, Index rate, double s)
{
  hessian(rate, kH) += s;
  hessian(kH, rate) += s;
}

}  // namespace

struct SimpsonDynamics::Nodes
{
  std::array<double, kNodes> v, phi, tangent, yaw_rate, turned, cosine, sine;  ///< turned: sum_j S_ij r_j
};

SimpsonDynamics::SimpsonDynamics(const Robot& robot, Mode mode)
  : k_(curvature_gain(robot, mode)),
    beta_(traits_of(mode).course.angle),
    gamma_(traits_of(mode).follows_phi ? 1.0 : 0.0)
{}

SimpsonDynamics::Nodes SimpsonDynamics::nodes(const State& x, const Control& u) const
{
  Nodes n;
  const double h = u[2];
  for (std::size_t i = 0; i < kNodes; ++i)
  {
    n.v[i] = x[3] + kTime[i] * u[0] * h;
    n.phi[i] = x[4] + kTime[i] * u[1] * h;
    n.tangent[i] = k_ != 0.0 ? std::tan(n.phi[i]) : 0.0;
    n.yaw_rate[i] = n.v[i] * k_ * n.tangent[i];
  }
  for (std::size_t i = 0; i < kNodes; ++i)
  {
    n.turned[i] = kPartial[i][0] * n.yaw_rate[0] + kPartial[i][1] * n.yaw_rate[1] + kPartial[i][2] * n.yaw_rate[2];
    const double psi = x[2] + beta_ + gamma_ * n.phi[i] + h * n.turned[i];
    n.cosine[i] = std::cos(psi);
    n.sine[i] = std::sin(psi);
  }
  return n;
}

SimpsonDynamics::State SimpsonDynamics::next(const State& x, const Control& u) const
{
  const Nodes n = nodes(x, u);
  const double h = u[2];
  State result = x;
  for (std::size_t i = 0; i < kNodes; ++i)
  {
    result[0] += h * kWeight[i] * n.v[i] * n.cosine[i];
    result[1] += h * kWeight[i] * n.v[i] * n.sine[i];
  }
  result[2] += h * n.turned[2];
  result[3] = n.v[2];
  result[4] = n.phi[2];
  return result;
}

void SimpsonDynamics::differentiate(const State& x, const Control& u, const State& lambda, Jacobian& jacobian,
                                    Hessian& hessian) const
{
  const Nodes n = nodes(x, u);
  const double a = u[0], omega = u[1], h = u[2];

  // First derivatives at the nodes: of v, phi, r, the sum S r, and psi.
  std::array<Variables, kNodes> dv, dphi, dr, dturned, dpsi;
  std::array<double, kNodes> slope;  // K (1 + tan^2): d(K tan)/d(phi)
  for (std::size_t i = 0; i < kNodes; ++i)
  {
    dv[i] << 0.0, 1.0, 0.0, kTime[i] * h, 0.0, kTime[i] * a;
    dphi[i] << 0.0, 0.0, 1.0, 0.0, kTime[i] * h, kTime[i] * omega;
    slope[i] = k_ * (1.0 + n.tangent[i] * n.tangent[i]);
    dr[i] = k_ * n.tangent[i] * dv[i] + n.v[i] * slope[i] * dphi[i];
  }
  for (std::size_t i = 0; i < kNodes; ++i)
  {
    dturned[i] = kPartial[i][0] * dr[0] + kPartial[i][1] * dr[1] + kPartial[i][2] * dr[2];
    dpsi[i] = gamma_ * dphi[i] + h * dturned[i];
    dpsi[i][kTheta] += 1.0;
    dpsi[i][kH] += n.turned[i];
  }

  Square second = Square::Zero();
  jacobian.setZero();
  jacobian(0, 0) = jacobian(1, 1) = jacobian(2, 2) = 1.0;

  // lambda_x x+ + lambda_y y+ = ... + sum_i w_i h v_i along_i, with d(along)/d(psi) = across.
  std::array<double, kNodes> on_turned = {0.0, 0.0, lambda[2]};  // factor of the second derivatives of h sum_j S_ij r_j
  for (std::size_t i = 0; i < kNodes; ++i)
  {
    const double w = kWeight[i], c = n.cosine[i], s = n.sine[i];
    const double along = lambda[0] * c + lambda[1] * s, across = lambda[1] * c - lambda[0] * s;
    const Variables dx = c * dv[i] - n.v[i] * s * dpsi[i], dy = s * dv[i] + n.v[i] * c * dpsi[i];
    jacobian.row(0).tail<6>() += w * h * dx.transpose();
    jacobian.row(1).tail<6>() += w * h * dy.transpose();
    jacobian(0, 2 + kH) += w * n.v[i] * c;
    jacobian(1, 2 + kH) += w * n.v[i] * s;

    const Variables product = w * (lambda[0] * dx + lambda[1] * dy);
    second += w * h * (across * symmetric(dv[i], dpsi[i]) - n.v[i] * along * dpsi[i] * dpsi[i].transpose());
    second.row(kH) += product.transpose();
    second.col(kH) += product;
    add_product(second, kA, w * h * along * kTime[i]);
    add_product(second, kOmega, w * h * n.v[i] * across * gamma_ * kTime[i]);
    on_turned[i] += w * h * n.v[i] * across;
  }
  jacobian.row(2).tail<6>() += h * dturned[2].transpose();
  jacobian(2, 2 + kH) += n.turned[2];
  jacobian.row(3).tail<6>() = dv[2].transpose();
  jacobian.row(4).tail<6>() = dphi[2].transpose();

  for (std::size_t i = 0; i < kNodes; ++i)
  {
    if (k_ == 0.0) break;
    second.row(kH) += on_turned[i] * dturned[i].transpose();
    second.col(kH) += on_turned[i] * dturned[i];
  }
  for (std::size_t j = 0; j < kNodes && k_ != 0.0; ++j)
  {
    double on_rate = 0.0;  // factor of the second derivatives of r_j
    for (std::size_t i = 0; i < kNodes; ++i) on_rate += h * on_turned[i] * kPartial[i][j];
    second += on_rate * (slope[j] * symmetric(dv[j], dphi[j]) +
                         2.0 * n.v[j] * n.tangent[j] * slope[j] * dphi[j] * dphi[j].transpose());
    add_product(second, kA, on_rate * k_ * n.tangent[j] * kTime[j]);
    add_product(second, kOmega, on_rate * n.v[j] * slope[j] * kTime[j]);
  }
  add_product(second, kA, lambda[3]);
  add_product(second, kOmega, lambda[4]);
  hessian.bottomRightCorner<6, 6>() += second;
}

}  // namespace fourwis
