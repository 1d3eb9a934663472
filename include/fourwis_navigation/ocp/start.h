#pragma once

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/ocp/constraints.h"
#include "fourwis_navigation/ocp/evaluation.h"
#include "fourwis_navigation/ocp/iterate.h"

namespace fourwis::ocp
{
namespace detail
{

/// `value` moved to at least `push` (relative above 1, and at most 1/100 of the interval) inside of its bounds.
inline double moved_inside(double value, double lower, double upper, double push)
{
  const double width = 0.01 * (upper - lower);
  const double from = std::isfinite(lower) ? lower + std::min(push * std::max(1.0, std::abs(lower)), width) : lower;
  const double to = std::isfinite(upper) ? upper - std::min(push * std::max(1.0, std::abs(upper)), width) : upper;
  return std::clamp(value, from, to);
}

/// A multiplier to start with: mu / gap, or, within a factor of 1000 of that, the one given if it is positive.
inline double starting_multiplier(double gap, double mu, double given)
{
  const double central = mu / gap;
  return given > 0.0 ? std::clamp(given, 1e-3 * central, 1e3 * central) : central;
}

/// The elastic row on the central path with g - c = `over`: t y = mu, e v = mu, y + v = w and e - t = over give
///   min(y, v) = 2 mu w / (2 mu + |over| w + sqrt(4 mu^2 + over^2 w^2)),
/// which is v if the row is exceeded.
inline RowVariables central_elastic_row(double over, double weight, double mu)
{
  const double beyond = std::abs(over) * weight;
  const double small = 2.0 * mu * weight / (2.0 * mu + beyond + std::hypot(2.0 * mu, beyond));
  const double y = over > 0.0 ? weight - small : small;
  const double v = over > 0.0 ? small : weight - small;
  return {mu / y, mu / v, y, v};
}

/// Row with g - c = `over`, and with a multiplier close to `given` if that is positive.
inline RowVariables starting_row(double over, double weight, double mu, double push, double given)
{
  const bool elastic = std::isfinite(weight);
  if (elastic && !(given > 0.0 && given < weight)) return central_elastic_row(over, weight, mu);
  const double slack = std::max(-over, given > 0.0 ? std::min(mu / given, push) : push);
  const double y = std::min(starting_multiplier(slack, mu, given), 0.999 * weight);
  return {slack, elastic ? mu / (weight - y) : 0.0, y, weight - y};
}

/// Row after its multipliers were lost: an elastic one is met exactly, a hard one keeps its slack.
inline RowVariables restarted_row(const RowVariables& row, double over, double weight, double mu)
{
  if (std::isfinite(weight)) return central_elastic_row(over, weight, mu);
  return {row.slack, 0.0, mu / row.slack, kInfinity};
}

}  // namespace detail

/// Sets z to the guess, moved inside of the bounds by `push`.
template <int NX, int NU>
void start_primal(const Constraints<NX, NU>& constraints, const Trajectory<NX, NU>& guess, double push,
                  Iterate<NX, NU>& start)
{
  const std::size_t last = constraints.intervals();
  for (std::size_t k = 0; k <= last; ++k)
  {
    Vector<NX + NU>& z = start.stages[k].z;
    z.template head<NX>() = k == 0 ? constraints.initial_state : guess.states[k];
    if (k < last)
      z.template tail<NU>() = guess.controls[k];
    else
      z.template tail<NU>().setZero();
    for (int i = 0; i < NX + NU; ++i)
      z[i] = detail::moved_inside(z[i], constraints.bounds[k].lower[i], constraints.bounds[k].upper[i], push);
  }
}

/// Sets the multipliers of the bounds from the distances to them; with those `given` as far as they are of use.
template <int NX, int NU>
void start_bound_multipliers(const Constraints<NX, NU>& constraints, double mu, const Multipliers<NX, NU>* given,
                             Iterate<NX, NU>& start)
{
  for (std::size_t k = 0; k < start.stages.size(); ++k)
    for (int i = 0; i < NX + NU; ++i)
    {
      auto& stage = start.stages[k];
      const auto& bounds = constraints.bounds[k];
      stage.lower[i] = detail::starting_multiplier(stage.z[i] - bounds.lower[i], mu, given ? given->lower[k][i] : 0.0);
      stage.upper[i] = detail::starting_multiplier(bounds.upper[i] - stage.z[i], mu, given ? given->upper[k][i] : 0.0);
    }
}

template <int NX, int NU>
void start_equality_multipliers(const Constraints<NX, NU>& constraints, const Multipliers<NX, NU>* given,
                                Iterate<NX, NU>& start)
{
  start.stages[0].lambda.setZero();
  for (std::size_t k = 1; k < start.stages.size(); ++k)
    if (given)
      start.stages[k].lambda = given->dynamics[k - 1];
    else
      start.stages[k].lambda.setZero();
  for (int i = 0; i < NX; ++i) start.nu[i] = given && constraints.is_fixed(i) ? given->terminal[i] : 0.0;
}

/// Sets the variables of the rows from their values, and makes their residuals agree.
template <int NX, int NU>
void start_rows(const Constraints<NX, NU>& constraints, double mu, double push, const Multipliers<NX, NU>* given,
                Iterate<NX, NU>& start, Values<NX>& values)
{
  for (std::size_t i = 0; i < start.rows.size(); ++i)
  {
    const double over = values.rows[i] - constraints.rows[i].upper;
    RowVariables& row = start.rows[i];
    row = detail::starting_row(over, constraints.rows[i].weight, mu, push, given ? given->rows[i] : 0.0);
    values.residuals.rows[i] = over - row.excess + row.slack;
  }
}

/// The same after a feasibility step.
template <int NX, int NU>
void restart_rows(const Constraints<NX, NU>& constraints, double mu, Iterate<NX, NU>& at, Values<NX>& values)
{
  for (std::size_t i = 0; i < at.rows.size(); ++i)
  {
    const double over = values.rows[i] - constraints.rows[i].upper;
    at.rows[i] = detail::restarted_row(at.rows[i], over, constraints.rows[i].weight, mu);
    values.residuals.rows[i] = over - at.rows[i].excess + at.rows[i].slack;
  }
}

}  // namespace fourwis::ocp
