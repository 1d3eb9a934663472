#pragma once

#include <cmath>

#include "fourwis_navigation/ocp/evaluation.h"

namespace fourwis::ocp
{

/// Sum of logarithms of positive numbers, at the price of one logarithm for many of them.
class LogSum
{
public:
  void add(double value)
  {
    product_ *= value;
    if (product_ > 1e-100 && product_ < 1e100) return;
    // Factors beyond 1e-200..1e200 would make the product lose digits: none occurs in a well-posed problem.
    sum_ += std::log(product_);
    product_ = 1.0;
  }

  double value() const { return sum_ + std::log(product_); }

private:
  double sum_ = 0.0;
  double product_ = 1.0;
};

/// What a step is judged by, separated so that the barrier parameter may change.
struct Merit
{
  double cost = 0.0;        ///< with the elastic penalties
  double logarithms = 0.0;  ///< of all distances from bounds
  double violation = 0.0;   ///< sum of the equalities' absolute residuals

  double barrier(double mu) const { return cost - mu * logarithms; }
};

namespace detail
{

template <int N>
void add_gaps(const Vector<N>& z, const Vector<N>& lower, const Vector<N>& upper, LogSum& logarithms)
{
  for (int i = 0; i < N; ++i)
  {
    if (lower[i] > -kInfinity) logarithms.add(z[i] - lower[i]);
    if (upper[i] < kInfinity) logarithms.add(upper[i] - z[i]);
  }
}

}  // namespace detail

template <int NX, int NU>
Merit merit(const Constraints<NX, NU>& constraints, const Iterate<NX, NU>& at, const Values<NX>& values)
{
  LogSum logarithms;
  Merit result;
  result.cost = values.cost;
  for (std::size_t k = 0; k < at.stages.size(); ++k)
    detail::add_gaps(at.stages[k].z, constraints.bounds[k].lower, constraints.bounds[k].upper, logarithms);
  for (std::size_t i = 0; i < at.rows.size(); ++i)
  {
    logarithms.add(at.rows[i].slack);
    result.violation += std::abs(values.residuals.rows[i]);
    if (!std::isfinite(constraints.rows[i].weight)) continue;
    logarithms.add(at.rows[i].excess);
    result.cost += constraints.rows[i].weight * at.rows[i].excess;
  }
  for (const Vector<NX>& defect : values.residuals.defects) result.violation += defect.template lpNorm<1>();
  result.violation += values.residuals.terminal.template lpNorm<1>();
  result.logarithms = logarithms.value();
  return result;
}

/// Derivative of the barrier function along a step.
template <class Model, int NX, int NU>
double slope(const Constraints<NX, NU>& constraints, const Iterate<NX, NU>& at, const Derivatives<Model>& derivatives,
             const Iterate<NX, NU>& step, double mu)
{
  double result = 0.0;
  for (std::size_t k = 0; k < at.stages.size(); ++k)
  {
    const Vector<NX + NU>& z = at.stages[k].z;
    const auto barrier =
        mu / (constraints.bounds[k].upper - z).array() - mu / (z - constraints.bounds[k].lower).array();
    result += (derivatives.stages[k].gradient.array() + barrier).matrix().dot(step.stages[k].z);
  }
  for (std::size_t i = 0; i < at.rows.size(); ++i)
  {
    result -= mu / at.rows[i].slack * step.rows[i].slack;
    if (std::isfinite(constraints.rows[i].weight))
      result += (constraints.rows[i].weight - mu / at.rows[i].excess) * step.rows[i].excess;
  }
  return result;
}

}  // namespace fourwis::ocp
