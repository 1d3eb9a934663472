#pragma once

#include <algorithm>

#include "fourwis_navigation/ocp/constraints.h"
#include "fourwis_navigation/ocp/iterate.h"
#include "fourwis_navigation/ocp/model.h"

namespace fourwis::ocp
{

/// Values of a problem's functions at an iterate.
template <int NX>
struct Values
{
  double cost = 0.0;  ///< sum of the l_k and l_N
  Residuals<NX> residuals;
  std::vector<double> rows;  ///< g_i

  void resize(std::size_t intervals, std::size_t row_count)
  {
    residuals.defects.resize(intervals);
    residuals.rows.resize(row_count);
    rows.resize(row_count);
  }
};

/// Derivatives of a problem's functions at an iterate. The Hessians are those of the Lagrangian.
template <class Model>
struct Derivatives
{
  static constexpr int NX = Model::kStates, NU = Model::kControls, NQ = Model::kRowPoint;

  std::vector<StageDerivatives<NX, NU>> stages;  ///< N + 1; of the last only what concerns x_N
  std::vector<Vector<NQ>> rows;                  ///< dg_i/dq

  void resize(std::size_t stage_count, std::size_t row_count)
  {
    stages.resize(stage_count);
    rows.resize(row_count);
  }
};

template <class Model>
bool is_finite(const Derivatives<Model>& derivatives)
{
  return std::all_of(derivatives.stages.begin(), derivatives.stages.end(), [](const auto& stage) {
    return stage.jacobian.allFinite() && stage.gradient.allFinite() && stage.hessian.allFinite();
  });
}

namespace detail
{

template <int NX, int NU>
Vector<NX> state(const StageVariables<NX, NU>& stage)
{
  return stage.z.template head<NX>();
}

template <int NX, int NU>
Vector<NU> control(const StageVariables<NX, NU>& stage)
{
  return stage.z.template tail<NU>();
}

template <class Model, class Iterate, class Constraints>
void evaluate_rows(const Model& model, const Constraints& constraints, const Iterate& at,
                   Values<Model::kStates>& values)
{
  for (std::size_t k = 0; k <= constraints.intervals(); ++k)
  {
    const std::size_t first = constraints.first_row[k], end = constraints.first_row[k + 1];
    if (first == end) continue;
    model.rows(k, at.stages[k].z.template head<Model::kRowPoint>(),
               {&values.rows[first], static_cast<Eigen::Index>(end - first)});
  }
  for (std::size_t i = 0; i < at.rows.size(); ++i)
    values.residuals.rows[i] = values.rows[i] - constraints.rows[i].upper - at.rows[i].excess + at.rows[i].slack;
}

}  // namespace detail

/// Cost and residuals at an iterate. Values that are not finite end up in `cost` or the residuals.
template <class Model, class Iterate, class Constraints>
void evaluate(const Model& model, const Constraints& constraints, const Iterate& at, Values<Model::kStates>& values)
{
  const std::size_t last = constraints.intervals();
  values.cost = model.terminal_cost(detail::state(at.stages[last]));
  for (std::size_t k = 0; k < last; ++k)
  {
    typename Model::Value value;
    model.evaluate(k, detail::state(at.stages[k]), detail::control(at.stages[k]), detail::state(at.stages[k + 1]),
                   value);
    values.cost += value.cost;
    values.residuals.defects[k] = value.defect;
  }
  for (int i = 0; i < Model::kStates; ++i)
    values.residuals.terminal[i] = constraints.is_fixed(i) ? at.stages[last].z[i] - constraints.goal[i] : 0.0;
  detail::evaluate_rows(model, constraints, at, values);
}

namespace detail
{

template <class Model, class Iterate>
void differentiate_stages(const Model& model, const Iterate& at, Derivatives<Model>& derivatives)
{
  constexpr int NX = Model::kStates;
  const std::size_t last = at.stages.size() - 1;
  for (std::size_t k = 0; k <= last; ++k)
  {
    auto& stage = derivatives.stages[k];
    stage.jacobian.setZero();
    stage.gradient.setZero();
    stage.hessian.setZero();
    if (k < last) model.differentiate(k, state(at.stages[k]), control(at.stages[k]), at.stages[k + 1].lambda, stage);
  }
  typename Model::Terminal terminal{Vector<NX>::Zero(), Matrix<NX, NX>::Zero()};
  model.differentiate_terminal(state(at.stages[last]), terminal);
  derivatives.stages[last].gradient.template head<NX>() = terminal.gradient;
  derivatives.stages[last].hessian.template topLeftCorner<NX, NX>() = terminal.hessian;
}

template <class Model, class Iterate, class Constraints>
void differentiate_rows(const Model& model, const Constraints& constraints, const Iterate& at, std::vector<double>& y,
                        Derivatives<Model>& derivatives)
{
  constexpr int NQ = Model::kRowPoint;
  for (std::size_t k = 0; k <= constraints.intervals(); ++k)
  {
    const std::size_t first = constraints.first_row[k], end = constraints.first_row[k + 1];
    if (first == end) continue;
    const Eigen::Index count = static_cast<Eigen::Index>(end - first);
    for (std::size_t i = first; i < end; ++i)
    {
      y[i] = at.rows[i].multiplier;
      derivatives.rows[i].setZero();
    }
    typename Model::RowHessian hessian = Model::RowHessian::Zero();
    model.differentiate_rows(k, at.stages[k].z.template head<NQ>(), {&y[first], count},
                             {derivatives.rows[first].data(), NQ, count}, hessian);
    derivatives.stages[k].hessian.template topLeftCorner<NQ, NQ>() += hessian;
  }
}

}  // namespace detail

/// Derivatives at an iterate; `y` is scratch space for the multipliers of the rows.
template <class Model, class Iterate, class Constraints>
void differentiate(const Model& model, const Constraints& constraints, const Iterate& at, std::vector<double>& y,
                   Derivatives<Model>& derivatives)
{
  detail::differentiate_stages(model, at, derivatives);
  detail::differentiate_rows(model, constraints, at, y, derivatives);
}

}  // namespace fourwis::ocp
