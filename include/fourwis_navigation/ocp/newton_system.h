#pragma once

#include <type_traits>

#include "fourwis_navigation/ocp/evaluation.h"
#include "fourwis_navigation/ocp/riccati.h"

namespace fourwis::ocp
{

/// What a row adds to the Newton step. Linearised, its three equations
///   g + dg' dz - c - (e + de) + (t + dt) = 0,   t y + t dy + y dt = mu,   e v + e dv + v de = mu  (v = weight - y)
/// give, with r = g - c - e + t,
///   dy = sigma (dg' dz + r + shift),   sigma = 1 / (t/y + e/v),   shift = mu/y - t - mu/v + e,
///   dt = mu/y - t - t/y dy,            de = mu/v - e + e/v dy,    dv = -dy.
struct RowElimination
{
  double sigma, shift;

  RowElimination() = default;
  RowElimination(const RowVariables& row, double mu)
    : sigma(1.0 / (row.slack / row.multiplier + row.excess / row.excess_multiplier)),
      shift(mu / row.multiplier - row.slack - mu / row.excess_multiplier + row.excess)
  {}

  /// y + dy for dz = 0 and the residual r: what the row's gradient is multiplied by in the condensed gradient.
  double multiplier(const RowVariables& row, double r) const { return row.multiplier + sigma * (r + shift); }

  RowVariables step(const RowVariables& row, double mu, double residual_after_dz) const
  {
    const double dy = sigma * (residual_after_dz + shift);
    return {mu / row.multiplier - row.slack - row.slack / row.multiplier * dy,
            mu / row.excess_multiplier - row.excess + row.excess / row.excess_multiplier * dy, dy, -dy};
  }
};

/// The Newton system of the barrier problem. Bounds and rows are eliminated stage by stage, so that a linear-quadratic
/// problem in dz with the following H_k, h_k remains for the Riccati recursion:
///   H = L_zz + diag(zl/(z - l) + zu/(u - z)) + sum_i sigma_i dg_i dg_i',
///   h = l_z + mu/(u - z) - mu/(z - l) + sum_i (y_i + sigma_i (r_i + shift_i)) dg_i,
/// zl, zu being the bounds' multipliers l, u. The terminal condition x_N - goal = delta (nu_new - nu) adds 1/delta and
/// nu + (x_N - goal)/delta. In the system of a feasibility step, L_zz is replaced by the unit matrix and l_z by 0.
template <class Model>
class NewtonSystem
{
public:
  static constexpr int NX = Model::kStates, NU = Model::kControls, NR = Model::kRowVariables, NZ = NX + NU;
  using Point = Iterate<NX, NU>;
  using Limits = Constraints<NX, NU>;
  enum class Aim
  {
    optimality,
    feasibility
  };

  void resize(std::size_t stage_count, std::size_t row_count)
  {
    stages_.resize(stage_count);
    rows_.resize(row_count);
    riccati_.resize(stage_count);
  }

  /// Sets the matrices at `at`. All arguments are kept by reference until the next call; delta is the regularisation
  /// of the terminal condition.
  void assemble(const Limits& limits, const Point& at, const Derivatives<Model>& derivatives, double mu, double delta,
                Aim aim = Aim::optimality);

  /// False if the system with `regularization` added to H is not that of a minimum.
  bool factorize(double regularization) { return riccati_.factorize(stages_, regularization); }

  /// Step towards the solution of the linearised equations with the given residuals.
  void solve(const Residuals<NX>& residuals, Point& step);

private:
  template <int N>
  using Width = std::integral_constant<int, N>;

  /// Calls visit(i, v) for the rows of stage k; the row's gradient is zero beyond the first v components.
  template <class Visit>
  void for_rows(std::size_t k, Visit visit) const;

  void add_row_hessians(std::size_t k);
  void set_gradients(const Residuals<NX>& residuals);
  void finish_step(const Residuals<NX>& residuals, Point& step) const;

  const Limits* limits_ = nullptr;
  const Point* at_ = nullptr;
  const Derivatives<Model>* derivatives_ = nullptr;
  double mu_ = 0.0, delta_ = 0.0;
  Aim aim_ = Aim::optimality;
  typename Riccati<NX, NU>::Stages stages_;
  std::vector<RowElimination> rows_;
  Riccati<NX, NU> riccati_;
};

template <class Model>
void NewtonSystem<Model>::assemble(const Limits& limits, const Point& at, const Derivatives<Model>& derivatives,
                                   double mu, double delta, Aim aim)
{
  limits_ = &limits;
  at_ = &at;
  derivatives_ = &derivatives;
  mu_ = mu;
  delta_ = delta;
  aim_ = aim;
  for (std::size_t k = 0; k <= limits.intervals(); ++k)
  {
    const auto& variables = at.stages[k];
    auto& stage = stages_[k];
    stage.jacobian_transposed = derivatives.stages[k].jacobian.transpose();
    if (aim == Aim::optimality)
      stage.hessian = derivatives.stages[k].hessian;
    else
      stage.hessian.setIdentity();
    stage.hessian.diagonal().array() += variables.lower.array() / (variables.z - limits.bounds[k].lower).array() +
                                        variables.upper.array() / (limits.bounds[k].upper - variables.z).array();
    add_row_hessians(k);
  }
  for (int i = 0; i < NX; ++i)
    if (limits.is_fixed(i)) stages_[limits.intervals()].hessian(i, i) += 1.0 / delta;
}

template <class Model>
template <class Visit>
void NewtonSystem<Model>::for_rows(std::size_t k, Visit visit) const
{
  std::size_t i = limits_->first_row[k];
  if (k < limits_->intervals())
    for (const std::size_t narrow = i + std::size_t{Model::kWideRows}; i < narrow; ++i) visit(i, Width<NZ>());
  for (; i < limits_->first_row[k + 1]; ++i) visit(i, Width<NR>());
}

template <class Model>
void NewtonSystem<Model>::add_row_hessians(std::size_t k)
{
  auto& hessian = stages_[k].hessian;
  for_rows(k, [&](std::size_t i, auto width) {
    constexpr int n = decltype(width)::value;
    rows_[i] = RowElimination(at_->rows[i], mu_);
    const Vector<n> gradient = derivatives_->rows[i].template head<n>();
    hessian.template topLeftCorner<n, n>().noalias() += (rows_[i].sigma * gradient) * gradient.transpose();
  });
}

template <class Model>
void NewtonSystem<Model>::set_gradients(const Residuals<NX>& residuals)
{
  const std::size_t last = limits_->intervals();
  for (std::size_t k = 0; k <= last; ++k)
  {
    const Vector<NZ>& z = at_->stages[k].z;
    auto& stage = stages_[k];
    if (k < last) stage.defect = residuals.defects[k];
    stage.gradient.array() =
        mu_ / (limits_->bounds[k].upper - z).array() - mu_ / (z - limits_->bounds[k].lower).array();
    if (aim_ == Aim::optimality) stage.gradient += derivatives_->stages[k].gradient;
    for_rows(k, [&](std::size_t i, auto width) {
      constexpr int n = decltype(width)::value;
      stage.gradient.template head<n>() +=
          rows_[i].multiplier(at_->rows[i], residuals.rows[i]) * derivatives_->rows[i].template head<n>();
    });
  }
  for (int i = 0; i < NX; ++i)
    if (limits_->is_fixed(i)) stages_[last].gradient[i] += at_->nu[i] + residuals.terminal[i] / delta_;
}

template <class Model>
void NewtonSystem<Model>::solve(const Residuals<NX>& residuals, Point& step)
{
  set_gradients(residuals);
  riccati_.solve(stages_, step.stages);
  finish_step(residuals, step);
}

/// The parts of the step that were eliminated.
template <class Model>
void NewtonSystem<Model>::finish_step(const Residuals<NX>& residuals, Point& step) const
{
  const std::size_t last = limits_->intervals();
  for (std::size_t k = 0; k <= last; ++k)
  {
    const auto& variables = at_->stages[k];
    const auto dz = step.stages[k].z.array();
    const auto zl = variables.lower.array(), zu = variables.upper.array();
    step.stages[k].lambda -= variables.lambda;
    step.stages[k].lower = (mu_ - zl * dz) / (variables.z - limits_->bounds[k].lower).array() - zl;
    step.stages[k].upper = (mu_ + zu * dz) / (limits_->bounds[k].upper - variables.z).array() - zu;
    for_rows(k, [&](std::size_t i, auto width) {
      constexpr int n = decltype(width)::value;
      const double change = derivatives_->rows[i].template head<n>().dot(step.stages[k].z.template head<n>());
      step.rows[i] = rows_[i].step(at_->rows[i], mu_, residuals.rows[i] + change);
    });
  }
  for (int i = 0; i < NX; ++i)
    step.nu[i] = limits_->is_fixed(i) ? (step.stages[last].z[i] + residuals.terminal[i]) / delta_ : 0.0;
}

}  // namespace fourwis::ocp
