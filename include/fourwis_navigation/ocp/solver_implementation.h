#pragma once

#include <cmath>

#include "fourwis_navigation/ocp/solver.h"
#include "fourwis_navigation/ocp/start.h"

namespace fourwis::ocp
{

template <class Model>
auto Solver<Model>::solve(const Model& model, const Problem& problem, const Trajectory& guess, const Options& options,
                          const Multipliers* multipliers, const Interrupted& interrupted) -> const Solution&
{
  check(options);
  model_ = &model;
  options_ = options;
  solution_.statistics = {};
  solution_.status = Status::invalid_problem;
  if (!is_valid(problem, Model::kWideRows) || !has_size(guess, problem.intervals())) return solution_;
  if (multipliers && !has_size(*multipliers, problem)) return solution_;
  solution_.status = Status::not_finite;
  if (!is_finite(guess)) return solution_;
  set_up(problem);
  start(guess, multipliers);
  solution_.status = run(interrupted);
  report();
  return solution_;
}

template <class Model>
void Solver<Model>::set_up(const Problem& problem)
{
  constraints_.set(problem);
  const std::size_t intervals = constraints_.intervals(), rows = constraints_.rows.size();
  for (Point* point : {&current_, &trial_, &step_, &correction_}) point->resize(intervals + 1, rows);
  for (Values<NX>* values : {&values_, &trial_values_}) values->resize(intervals, rows);
  corrected_residuals_.defects.resize(intervals);
  corrected_residuals_.rows.resize(rows);
  derivatives_.resize(intervals + 1, rows);
  newton_.resize(intervals + 1, rows);
  row_multipliers_.resize(rows);
  filter_.reserve(static_cast<std::size_t>(options_.max_iterations) + 1);
}

template <class Model>
void Solver<Model>::start(const Trajectory& guess, const Multipliers* multipliers)
{
  mu_ = options_.initial_barrier;
  regularization_ = forced_regularization_ = 0.0;
  stalled_ = 0;
  const double push = std::min(0.01, mu_);
  start_primal(constraints_, guess, push, current_);
  std::fill(current_.rows.begin(), current_.rows.end(), RowVariables{});
  evaluate(*model_, constraints_, current_, values_);
  start_rows(constraints_, mu_, push, multipliers, current_, values_);
  start_bound_multipliers(constraints_, mu_, multipliers, current_);
  start_equality_multipliers(constraints_, multipliers, current_);
  merit_ = merit(constraints_, current_, values_);
  filter_.reset(merit_.violation);
}

template <class Model>
Status Solver<Model>::run(const Interrupted& interrupted)
{
  Statistics& statistics = solution_.statistics;
  while (true)
  {
    differentiate(*model_, constraints_, current_, row_multipliers_, derivatives_);
    const Optimality state = optimality(constraints_, current_, values_, derivatives_);
    statistics.error = state.error(0.0);
    statistics.infeasibility = state.infeasibility;
    if (!state.is_finite() || !std::isfinite(merit_.cost)) return Status::not_finite;
    if (statistics.error <= options_.tolerance) return Status::solved;
    if (statistics.iterations == options_.max_iterations) return failure(Status::iteration_limit);
    if (interrupted && interrupted()) return Status::interrupted;
    reduce_barrier(state);
    if (const std::optional<Status> problem = advance()) return *problem;
    ++statistics.iterations;
  }
}

/// Monotone strategy: once the barrier problem is solved to 10 mu, the next one.
template <class Model>
void Solver<Model>::reduce_barrier(const Optimality& optimality)
{
  const double least = options_.tolerance / 10.0;
  while (mu_ > least && optimality.error(mu_) < 10.0 * mu_)
  {
    mu_ = std::max(least, std::min(options_.barrier_factor * mu_, std::pow(mu_, options_.barrier_power)));
    filter_.clear();
  }
}

/// Nothing more can be done: good enough? A second derivative that is not finite shows nowhere else.
template <class Model>
Status Solver<Model>::failure(Status status) const
{
  if (!is_finite(derivatives_)) return Status::not_finite;
  return solution_.statistics.error <= options_.acceptable_tolerance ? Status::acceptable : status;
}

template <class Model>
void Solver<Model>::report()
{
  const std::size_t last = constraints_.intervals();
  Trajectory& trajectory = solution_.trajectory;
  Multipliers& multipliers = solution_.multipliers;
  trajectory.states.resize(last + 1);
  trajectory.controls.resize(last);
  multipliers.resize(last, current_.rows.size());
  for (std::size_t k = 0; k <= last; ++k)
  {
    const auto& stage = current_.stages[k];
    trajectory.states[k] = detail::state(stage);
    multipliers.lower[k] = stage.lower;
    multipliers.upper[k] = stage.upper;
    if (k == last) break;
    trajectory.controls[k] = detail::control(stage);
    multipliers.dynamics[k] = current_.stages[k + 1].lambda;
  }
  multipliers.terminal = current_.nu;
  report_rows();
}

template <class Model>
void Solver<Model>::report_rows()
{
  solution_.excess.resize(current_.rows.size());
  for (std::size_t i = 0; i < current_.rows.size(); ++i)
  {
    const double excess = std::max(0.0, values_.rows[i] - constraints_.rows[i].upper);
    solution_.excess[i] = excess;
    solution_.multipliers.rows[i] = current_.rows[i].multiplier;
    if (std::isfinite(constraints_.rows[i].weight))
      solution_.statistics.elastic_violation = std::max(solution_.statistics.elastic_violation, excess);
  }
  solution_.statistics.cost = values_.cost;
}

}  // namespace fourwis::ocp
