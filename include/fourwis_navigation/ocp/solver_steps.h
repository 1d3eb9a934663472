#pragma once

#include <cmath>
#include <utility>

#include "fourwis_navigation/ocp/solver.h"
#include "fourwis_navigation/ocp/start.h"

namespace fourwis::ocp
{

template <class Model>
std::optional<Status> Solver<Model>::advance()
{
  if (!factorize()) return failure(Status::stalled);
  newton_.solve(values_.residuals, step_);
  if (!search_line()) return reduce_violation();
  forced_regularization_ = 0.0;
  stalled_ = 0;
  return {};
}

/// Adds to the diagonal of the Hessian what the Newton system needs to be that of a minimum, nothing if possible.
template <class Model>
bool Solver<Model>::factorize()
{
  constexpr double first = 1e-4, greatest = 1e10;
  newton_.assemble(constraints_, current_, derivatives_, mu_, options_.terminal_regularization);
  if (newton_.factorize(forced_regularization_)) return true;
  const double growth = regularization_ > 0.0 ? 8.0 : 100.0;
  double value =
      std::max(forced_regularization_, regularization_ > 0.0 ? std::max(1e-20, regularization_ / 3.0) : first);
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
  const StepLengths lengths = fraction_to_boundary(constraints_, current_, step_, boundary_fraction());
  const SearchPoint start{merit_.violation, merit_.barrier(mu_),
                          slope(constraints_, current_, derivatives_, step_, mu_)};
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
    if (alpha == lengths.primal && trial_merit_.violation >= start.violation && try_correction(start, alpha))
      return true;
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
  const StepLengths lengths = fraction_to_boundary(constraints_, current_, correction_, boundary_fraction());
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

/// Where no step is good for both, one that reduces the violation only. If there is none to reduce, the next Newton
/// step is made shorter.
template <class Model>
std::optional<Status> Solver<Model>::reduce_violation()
{
  constexpr double negligible = 1e-7;
  constexpr int most_feasibility_steps = 60, most_stalled = 3;
  if (solution_.statistics.feasibility_steps == most_feasibility_steps) return failure(Status::stalled);
  if (search_feasibility())
  {
    ++solution_.statistics.feasibility_steps;
    return {};
  }
  if (merit_.violation > negligible) return failure(Status::infeasible);
  if (++stalled_ > most_stalled) return failure(Status::stalled);
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
  const StepLengths lengths = fraction_to_boundary(constraints_, current_, step_, boundary_fraction());
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

/// After a feasibility step the multipliers say nothing: anew from the distances to the bounds. Elastic rows are met
/// again.
template <class Model>
void Solver<Model>::restart_multipliers()
{
  start_equality_multipliers<NX, NU>(constraints_, nullptr, current_);
  start_bound_multipliers<NX, NU>(constraints_, mu_, nullptr, current_);
  restart_rows(constraints_, mu_, current_, values_);
  merit_ = merit(constraints_, current_, values_);
}

}  // namespace fourwis::ocp
