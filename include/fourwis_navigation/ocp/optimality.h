#pragma once

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/ocp/evaluation.h"

namespace fourwis::ocp
{

/// How far an iterate is from the optimality conditions of the barrier problem with parameter mu: the error is the
/// greatest of
///   stationarity    |grad l + J' lambda - zl + zu + sum y dg| / s_d,
///   infeasibility   |residuals|,
///   complementarity |zl (z - l) - mu|, |zu (u - z) - mu|, |y t - mu|, |v e - mu| / s_c,
/// where s_d, s_c = max(100, mean multiplier) / 100 (Waechter and Biegler 2006, eq. 5 and 6).
struct Optimality
{
  double stationarity = 0.0;
  double infeasibility = 0.0;
  double least_product = kInfinity;
  double greatest_product = 0.0;
  double equality_multipliers = 0.0, bound_multipliers = 0.0;  ///< sums of absolute values
  int equality_count = 0, bound_count = 0;
  double checksum = 0.0;  ///< not finite if anything is not

  bool is_finite() const { return std::isfinite(checksum); }

  double error(double mu) const
  {
    const double s_d = scale(equality_multipliers + bound_multipliers, equality_count + bound_count);
    const double s_c = scale(bound_multipliers, bound_count);
    const double deviation = bound_count > 0 ? std::max(greatest_product - mu, mu - least_product) : 0.0;
    return std::max({stationarity / s_d, infeasibility, deviation / s_c});
  }

  void add_stationarity(double value)
  {
    stationarity = std::max(stationarity, std::abs(value));
    checksum += value;
  }

  void add_residual(double value)
  {
    infeasibility = std::max(infeasibility, std::abs(value));
    checksum += value;
  }

  void add_equality_multiplier(double value)
  {
    equality_multipliers += std::abs(value);
    ++equality_count;
  }

  void add_product(double gap, double multiplier)
  {
    least_product = std::min(least_product, gap * multiplier);
    greatest_product = std::max(greatest_product, gap * multiplier);
    bound_multipliers += multiplier;
    ++bound_count;
    checksum += multiplier;
  }

private:
  static double scale(double sum, int count) { return std::max(100.0, sum / std::max(1, count)) / 100.0; }
};

namespace detail
{

/// Gradient of the Lagrangian with respect to z_k, the bounds' part included.
template <class Model, class Iterate>
auto lagrangian_gradient(const Derivatives<Model>& derivatives, const Iterate& at, std::size_t k, std::size_t first_row,
                         std::size_t end_row)
{
  constexpr int NX = Model::kStates, NU = Model::kControls;
  const auto& stage = at.stages[k];
  Vector<NX + NU> gradient = derivatives.stages[k].gradient - stage.lower + stage.upper;
  if (k + 1 < at.stages.size())
    gradient.noalias() += derivatives.stages[k].jacobian.transpose() * at.stages[k + 1].lambda;
  gradient.template head<NX>() -= stage.lambda;
  for (std::size_t i = first_row; i < end_row; ++i)
    gradient.template head<Model::kRowPoint>() += at.rows[i].multiplier * derivatives.rows[i];
  return gradient;
}

template <class Constraints, class Iterate>
void add_bounds(const Constraints& constraints, const Iterate& at, std::size_t k, Optimality& optimality)
{
  const auto& stage = at.stages[k];
  const auto& bounds = constraints.bounds[k];
  for (int i = 0; i < stage.z.size(); ++i)
  {
    if (bounds.lower[i] > -kInfinity) optimality.add_product(stage.z[i] - bounds.lower[i], stage.lower[i]);
    if (bounds.upper[i] < kInfinity) optimality.add_product(bounds.upper[i] - stage.z[i], stage.upper[i]);
  }
}

inline void add_row(const RowVariables& row, double residual, bool elastic, Optimality& optimality)
{
  optimality.add_residual(residual);
  optimality.add_product(row.slack, row.multiplier);
  if (elastic) optimality.add_product(row.excess, row.excess_multiplier);
}

}  // namespace detail

template <class Model, class Iterate, class Constraints>
Optimality optimality(const Constraints& constraints, const Iterate& at, const Values<Model::kStates>& values,
                      const Derivatives<Model>& derivatives)
{
  constexpr int NX = Model::kStates, NU = Model::kControls;
  Optimality result;
  const std::size_t last = constraints.intervals();
  for (std::size_t k = 0; k <= last; ++k)
  {
    const std::size_t first = constraints.first_row[k], end = constraints.first_row[k + 1];
    auto gradient = detail::lagrangian_gradient(derivatives, at, k, first, end);
    if (k == last) gradient.template head<NX>() += at.nu;
    if (k > 0)
      for (int i = 0; i < NX; ++i) result.add_stationarity(gradient[i]);
    if (k < last)
      for (int i = NX; i < NX + NU; ++i) result.add_stationarity(gradient[i]);
    if (k < last)
      for (int i = 0; i < NX; ++i) result.add_residual(values.residuals.defects[k][i]);
    if (k > 0)
      for (int i = 0; i < NX; ++i) result.add_equality_multiplier(at.stages[k].lambda[i]);
    detail::add_bounds(constraints, at, k, result);
    for (std::size_t i = first; i < end; ++i)
      detail::add_row(at.rows[i], values.residuals.rows[i], std::isfinite(constraints.rows[i].weight), result);
  }
  for (int i = 0; i < NX; ++i) result.add_residual(values.residuals.terminal[i]);
  return result;
}

}  // namespace fourwis::ocp
