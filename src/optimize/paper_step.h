#pragma once

#include <cstddef>
#include <vector>

#include "fourwis_navigation/optimize/paper_optimizer.h"
#include "nlp.h"
#include "paper_dynamics.h"

namespace fourwis
{

/// One step k: its share of the duration, of the comfort and of J_dyn, and the rows that make d_k the residual:
///   c = h + alpha (v omega)^2 h + weight |d|^2,   F(x, u, h) - x+ + d = 0,   h = T/N.
class PaperStep : public NlpElement
{
public:
  static constexpr int kNext = EulerDynamics::kVariables;           ///< where x+ begins among the variables
  static constexpr int kResidual = kNext + EulerDynamics::kStates;  ///< where d begins

  /// `variables`: x, u, T, x+, d.
  PaperStep(const EulerDynamics& dynamics, const PaperOptions& options, std::size_t steps, std::vector<int> variables);

  double evaluate(const Eigen::VectorXd& x, Eigen::Ref<Eigen::VectorXd> rows) const override;
  void differentiate(const Eigen::VectorXd& x, double s, const Eigen::VectorXd& y, Derivatives& d) const override;

private:
  EulerDynamics::Variables step_variables(const Eigen::VectorXd& x) const;
  void differentiate_cost(const EulerDynamics::Variables& z, double s, Derivatives& d) const;

  const EulerDynamics dynamics_;
  const double alpha_, weight_, steps_;
};

}  // namespace fourwis
