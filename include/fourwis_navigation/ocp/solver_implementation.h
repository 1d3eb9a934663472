#pragma once

#include <cmath>
#include <utility>

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
  if (!is_valid(problem) || !has_size(guess, problem.intervals())) return solution_;
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
  filter_.reserve(options_.max_iterations + 1);
}

template <class Model>
void Solver<Model>::start(const Trajectory& guess, const Multipliers* multipliers)
{
  mu_ = options_.initial_barrier;
  regularization_ = forced_regularization_ = 0.0;
  fruitless_ = 0;
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
    if (statistics.iterations == options_.max_iterations) return Status::iteration_limit;
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
std::optional<Status> Solver<Model>::advance()
{
  if (!factorize()) return failure(Status::stalled);
  newton_.solve(values_.residuals, step_);
  if (!search_line()) return reduce_violation();
  forced_regularization_ = 0.0;
  fruitless_ = 0;
  return {};
}

/// Adds to the diagonal of the Hessian what the Newton system needs to be that of a minimum; the first try is none at all.
template <class Model>
bool Solver<Model>::factorize()
{
  constexpr double first = 1e-4, greatest = 1e10;
  newton_.assemble(constraints_, current_, derivatives_, mu_, options_.terminal_regularization);
  if (newton_.factorize(forced_regularization_)) return true;
  const double growth = regularization_ > 0.0 ? 8.0 : 100.0;
  double value = std::max(forced_regularization_, regularization_ > 0.0 ? std::max(1e-20, regularization_ / 3.0) : first);
  for (; value <= greatest; value *= growth)
  {
    ++solution_.statistics.regularizations;
    if (!newton_.factorize(value)) continue;
    regularization_ = value;
    return true;
  }
  return false;
}

/// Backtracks from the longest step that stays inside; where that one fails for more violation, corrects it once.
template <class Model>
bool Solver<Model>::search_line()
{
  constexpr double least_alpha = 1e-8;
  const StepLengths lengths = fraction_to_boundary(constraints_, current_, step_, std::max(0.99, 1.0 - mu_));
  const SearchPoint start{merit_.violation, merit_.barrier(mu_), slope(constraints_, current_, derivatives_, step_, mu_)};
  for (double alpha = lengths.primal; alpha > least_alpha; alpha *= 0.5)
  {
    try_step(step_, alpha);
    const Filter::Verdict verdict = judge(start, alpha);
    if (verdict != Filter::Verdict::rejected)
    {
      if (verdict == Filter::Verdict::makes_progress) filter_.add(start.violation, start.barrier);
      accept(step_, alpha, lengths.dual);
      return true;
    }
    if (alpha == lengths.primal && trial_merit_.violation >= start.violation && try_correction(start, alpha)) return true;
  }
  return false;
}

/// trial <- current + alpha step, evaluated
template <class Model>
void Solver<Model>::try_step(const Point& step, double alpha)
{
  move_primal(current_, step, alpha, trial_);
  evaluate(*model_, constraints_, trial_, trial_values_);
  trial_merit_ = merit(constraints_, trial_, trial_values_);
}

template <class Model>
Filter::Verdict Solver<Model>::judge(const SearchPoint& start, double alpha) const
{
  return filter_.judge(start, alpha, trial_merit_.violation, trial_merit_.barrier(mu_));
}

/// Second-order correction: the same matrices, with the residuals that the step left added to those it should remove.
template <class Model>
bool Solver<Model>::try_correction(const SearchPoint& start, double alpha)
{
  const Residuals<NX>&old = values_.residuals, &left = trial_values_.residuals;
  for (std::size_t k = 0; k < old.defects.size(); ++k)
    corrected_residuals_.defects[k] = alpha * old.defects[k] + left.defects[k];
  for (std::size_t i = 0; i < old.rows.size(); ++i) corrected_residuals_.rows[i] = alpha * old.rows[i] + left.rows[i];
  corrected_residuals_.terminal = alpha * old.terminal + left.terminal;

  newton_.solve(corrected_residuals_, correction_);
  const StepLengths lengths = fraction_to_boundary(constraints_, current_, correction_, std::max(0.99, 1.0 - mu_));
  try_step(correction_, lengths.primal);
  const Filter::Verdict verdict = judge(start, alpha);
  if (verdict == Filter::Verdict::rejected) return false;
  if (verdict == Filter::Verdict::makes_progress) filter_.add(start.violation, start.barrier);
  accept(correction_, lengths.primal, lengths.dual);
  ++solution_.statistics.corrections;
  return true;
}

/// Makes the trial point, which the step led to, the current one.
template <class Model>
void Solver<Model>::accept(const Point& step, double primal, double dual)
{
  move_dual(constraints_, current_, step, primal, dual, mu_, trial_);
  std::swap(current_, trial_);
  std::swap(values_, trial_values_);
  merit_ = trial_merit_;
}

/// Where no step is good for both, one that reduces the violation only. If there is none to reduce, the next Newton step
/// is made shorter.
template <class Model>
std::optional<Status> Solver<Model>::reduce_violation()
{
  constexpr double negligible = 1e-7;
  constexpr int most_feasibility_steps = 60, most_fruitless = 3;
  if (solution_.statistics.feasibility_steps == most_feasibility_steps) return failure(Status::stalled);
  if (search_feasibility())
  {
    ++solution_.statistics.feasibility_steps;
    return {};
  }
  if (merit_.violation > negligible) return failure(Status::infeasible);
  if (++fruitless_ > most_fruitless) return failure(Status::stalled);
  forced_regularization_ = std::max(1e-4, 10.0 * std::max(regularization_, forced_regularization_));
  filter_.clear();
  return {};
}

/// A step of least length (in the metric of the barrier) to the linearised constraints.
template <class Model>
bool Solver<Model>::search_feasibility()
{
  constexpr double least_alpha = 1e-6;
  newton_.assemble(constraints_, current_, derivatives_, mu_, options_.terminal_regularization, Aim::feasibility);
  if (!newton_.factorize(1e-8)) return false;
  newton_.solve(values_.residuals, step_);
  const StepLengths lengths = fraction_to_boundary(constraints_, current_, step_, std::max(0.99, 1.0 - mu_));
  for (double alpha = lengths.primal; alpha > least_alpha; alpha *= 0.5)
  {
    try_step(step_, alpha);
    const bool finite = std::isfinite(trial_merit_.violation) && std::isfinite(trial_merit_.barrier(mu_));
    if (!finite || trial_merit_.violation > 0.9999 * (1.0 - 1e-3 * alpha) * merit_.violation) continue;
    filter_.add(merit_.violation, merit_.barrier(mu_));
    accept(step_, alpha, 0.0);
    restart_multipliers();
    return true;
  }
  return false;
}

/// After a feasibility step the multipliers say nothing: anew from the distances to the bounds. Elastic rows are met again.
template <class Model>
void Solver<Model>::restart_multipliers()
{
  start_equality_multipliers<NX, NU>(constraints_, nullptr, current_);
  start_bound_multipliers<NX, NU>(constraints_, mu_, nullptr, current_);
  restart_rows(constraints_, mu_, current_, values_);
  merit_ = merit(constraints_, current_, values_);
}

template <class Model>
void Solver<Model>::report()
{
  const int last = constraints_.intervals();
  Trajectory& trajectory = solution_.trajectory;
  Multipliers& multipliers = solution_.multipliers;
  trajectory.states.resize(last + 1);
  trajectory.controls.resize(last);
  multipliers.resize(last, current_.rows.size());
  for (int k = 0; k <= last; ++k)
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
