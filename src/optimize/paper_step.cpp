#include "paper_step.h"

#include <utility>

namespace fourwis
{
namespace
{

// The variables; h takes the place of T where the dynamics are concerned.
constexpr int kX = 0, kY = 1, kTheta = 2, kV = 3, kPhi = 4, kA = 5, kOmega = 6, kT = 7, kH = 7;
constexpr int kStates = EulerDynamics::kStates, kStepVariables = EulerDynamics::kVariables;
constexpr int kNext = PaperStep::kNext, kResidual = PaperStep::kResidual;

}  // namespace

PaperStep::PaperStep(const EulerDynamics& dynamics, const PaperOptions& options, std::size_t steps,
                     std::vector<int> the_variables)
  : NlpElement(std::move(the_variables), kStates),
    dynamics_(dynamics),
    alpha_(options.steering_comfort),
    weight_(options.penalty),
    steps_(static_cast<double>(steps))
{
  jacobian_pattern.setConstant(false);
  hessian_pattern.setConstant(false);
  for (int row = 0; row < kStates; ++row)
    for (int column : {row, kT, kNext + row, kResidual + row}) jacobian_pattern(row, column) = true;
  for (int column : {kTheta, kV, kPhi}) jacobian_pattern(kX, column) = jacobian_pattern(kY, column) = true;
  jacobian_pattern(kTheta, kV) = jacobian_pattern(kTheta, kPhi) = true;
  jacobian_pattern(kV, kA) = jacobian_pattern(kPhi, kOmega) = true;
  hessian_pattern.block(kTheta, kTheta, kT + 1 - kTheta, kT + 1 - kTheta).setConstant(true);
  for (int i = 0; i < kStates; ++i) hessian_pattern(kResidual + i, kResidual + i) = true;
}

/// (x, u, h) for the dynamics, from (x, u, T).
EulerDynamics::Variables PaperStep::step_variables(const Eigen::VectorXd& x) const
{
  EulerDynamics::Variables z = x.head<kStepVariables>();
  z[kH] /= steps_;
  return z;
}

double PaperStep::evaluate(const Eigen::VectorXd& x, Eigen::Ref<Eigen::VectorXd> rows) const
{
  const EulerDynamics::Variables z = step_variables(x);
  const double sweep = z[kV] * z[kOmega], h = z[kH];
  rows = dynamics_.next(z) - x.segment<kStates>(kNext) + x.tail<kStates>();
  return h + alpha_ * sweep * sweep * h + weight_ * x.tail<kStates>().squaredNorm();
}

void PaperStep::differentiate(const Eigen::VectorXd& x, double s, const Eigen::VectorXd& y, Derivatives& d) const
{
  const EulerDynamics::Variables z = step_variables(x);
  d.jacobian.leftCols<kStepVariables>() = dynamics_.jacobian(z);
  d.jacobian.middleCols<kStates>(kNext).diagonal().setConstant(-1.0);
  d.jacobian.rightCols<kStates>().diagonal().setConstant(1.0);
  d.hessian.topLeftCorner<kStepVariables, kStepVariables>() = dynamics_.hessian(z, y);
  differentiate_cost(z, s, d);

  // From h to T = N h.
  d.jacobian.col(kT) /= steps_;
  d.gradient[kT] /= steps_;
  d.hessian.row(kT) /= steps_;
  d.hessian.col(kT) /= steps_;

  d.gradient.tail<kStates>() = 2.0 * weight_ * x.tail<kStates>();
  d.hessian.bottomRightCorner<kStates, kStates>().diagonal().setConstant(2.0 * s * weight_);
}

/// c = h + alpha (v omega)^2 h
void PaperStep::differentiate_cost(const EulerDynamics::Variables& z, double s, Derivatives& d) const
{
  const double v = z[kV], omega = z[kOmega], h = z[kH];
  const auto add = [&](int i, int j, double value) {
    d.hessian(i, j) += s * alpha_ * value;
    if (i != j) d.hessian(j, i) += s * alpha_ * value;
  };
  d.gradient[kV] = 2.0 * alpha_ * v * omega * omega * h;
  d.gradient[kOmega] = 2.0 * alpha_ * v * v * omega * h;
  d.gradient[kH] = 1.0 + alpha_ * v * v * omega * omega;
  add(kV, kV, 2.0 * omega * omega * h);
  add(kV, kOmega, 4.0 * v * omega * h);
  add(kV, kH, 2.0 * v * omega * omega);
  add(kOmega, kOmega, 2.0 * v * v * h);
  add(kOmega, kH, 2.0 * v * v * omega);
}

}  // namespace fourwis
