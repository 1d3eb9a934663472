#pragma once

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/ocp/constraints.h"
#include "fourwis_navigation/ocp/iterate.h"

namespace fourwis::ocp
{

/// The longest parts of a step that keep positive what must be positive.
struct StepLengths
{
  double primal, dual;
};

namespace detail
{

/// Greatest relative decrease of a set of positive numbers.
class Decrease
{
public:
  void add(double value, double change)
  {
    if (change < 0.0) greatest_ = std::max(greatest_, -change / value);
  }

  /// alpha <= 1 with value + alpha change >= (1 - tau) value
  double step_length(double tau) const { return greatest_ > tau ? tau / greatest_ : 1.0; }

private:
  double greatest_ = 0.0;
};

}  // namespace detail

/// Fraction-to-the-boundary rule: the greatest alpha <= 1 that leaves at least (1 - tau) of each distance from a bound,
/// and of each multiplier.
template <int NX, int NU>
StepLengths fraction_to_boundary(const Constraints<NX, NU>& constraints, const Iterate<NX, NU>& at,
                                 const Iterate<NX, NU>& step, double tau)
{
  detail::Decrease primal, dual;
  for (std::size_t k = 0; k < at.stages.size(); ++k)
    for (int i = 0; i < NX + NU; ++i)
    {
      const double z = at.stages[k].z[i], dz = step.stages[k].z[i];
      primal.add(z - constraints.bounds[k].lower[i], dz);
      primal.add(constraints.bounds[k].upper[i] - z, -dz);
      dual.add(at.stages[k].lower[i], step.stages[k].lower[i]);
      dual.add(at.stages[k].upper[i], step.stages[k].upper[i]);
    }
  for (std::size_t i = 0; i < at.rows.size(); ++i)
  {
    primal.add(at.rows[i].slack, step.rows[i].slack);
    primal.add(at.rows[i].excess, step.rows[i].excess);
    dual.add(at.rows[i].multiplier, step.rows[i].multiplier);
    dual.add(at.rows[i].excess_multiplier, step.rows[i].excess_multiplier);
  }
  return {primal.step_length(tau), dual.step_length(tau)};
}

/// trial <- the primal variables of `at` + alpha step
template <int NX, int NU>
void move_primal(const Iterate<NX, NU>& at, const Iterate<NX, NU>& step, double alpha, Iterate<NX, NU>& trial)
{
  for (std::size_t k = 0; k < at.stages.size(); ++k) trial.stages[k].z = at.stages[k].z + alpha * step.stages[k].z;
  for (std::size_t i = 0; i < at.rows.size(); ++i)
  {
    trial.rows[i].slack = at.rows[i].slack + alpha * step.rows[i].slack;
    trial.rows[i].excess = at.rows[i].excess + alpha * step.rows[i].excess;
  }
}

namespace detail
{

/// Keeps multiplier * gap within 1e-10 .. 1e10 of mu, so that the primal-dual Hessian stays comparable to the barrier's
/// (Waechter and Biegler 2006, eq. 16). An infinite gap keeps its multiplier 0.
inline double safeguarded(double multiplier, double gap, double mu)
{
  constexpr double range = 1e10;
  const double central = mu / gap;
  return std::clamp(multiplier, central / range, central * range);
}

}  // namespace detail

/// trial <- the multipliers of `at` + a step, of the length `equalities` for lambda and nu, `bounds` for the others.
/// Needs the primal variables of `trial`.
template <int NX, int NU>
void move_dual(const Constraints<NX, NU>& constraints, const Iterate<NX, NU>& at, const Iterate<NX, NU>& step,
               double equalities, double bounds, double mu, Iterate<NX, NU>& trial)
{
  for (std::size_t k = 0; k < at.stages.size(); ++k)
  {
    const auto &old = at.stages[k], &change = step.stages[k];
    auto& stage = trial.stages[k];
    stage.lambda = old.lambda + equalities * change.lambda;
    for (int i = 0; i < NX + NU; ++i)
    {
      const double above = stage.z[i] - constraints.bounds[k].lower[i];
      const double below = constraints.bounds[k].upper[i] - stage.z[i];
      stage.lower[i] = detail::safeguarded(old.lower[i] + bounds * change.lower[i], above, mu);
      stage.upper[i] = detail::safeguarded(old.upper[i] + bounds * change.upper[i], below, mu);
    }
  }
  for (std::size_t i = 0; i < at.rows.size(); ++i)
  {
    trial.rows[i].multiplier = at.rows[i].multiplier + bounds * step.rows[i].multiplier;
    trial.rows[i].excess_multiplier = at.rows[i].excess_multiplier + bounds * step.rows[i].excess_multiplier;
  }
  trial.nu = at.nu + equalities * step.nu;
}

}  // namespace fourwis::ocp
