// The condensed Newton step against a dense solution of the linearised optimality conditions, all of them written out.

#include "fourwis_navigation/ocp/newton_system.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "fourwis_navigation/ocp/options.h"
#include "random_point.h"

namespace fourwis::ocp
{
namespace
{

using Model = RandomPoint::Model;
using Point = RandomPoint::Point;

/// The optimality conditions of the barrier problem, the terminal condition regularised around the point's nu.
struct Conditions : RandomPoint
{
  double mu = 0.07;
  double delta;  ///< regularisation of the terminal condition

  Conditions(unsigned seed, double delta_of_terminal) : RandomPoint(seed), delta(delta_of_terminal) {}

  /// The scalars that a step may change, in a fixed order.
  std::vector<double*> unknowns(Point& at) const
  {
    std::vector<double*> result;
    for (std::size_t k = 0; k <= intervals; ++k)
    {
      auto& stage = at.stages[k];
      for (int i = k == 0 ? NX : 0; i < (k < intervals ? NZ : NX); ++i) result.push_back(&stage.z[i]);
      for (int i = 0; i < NX && k > 0; ++i) result.push_back(&stage.lambda[i]);
      for (int i = 0; i < NZ; ++i)
      {
        if (limits.bounds[k].lower[i] > -kInfinity) result.push_back(&stage.lower[i]);
        if (limits.bounds[k].upper[i] < kInfinity) result.push_back(&stage.upper[i]);
      }
    }
    for (std::size_t i = 0; i < limits.rows.size(); ++i)
    {
      result.push_back(&at.rows[i].slack);
      result.push_back(&at.rows[i].multiplier);
      if (!std::isfinite(limits.rows[i].weight)) continue;
      result.push_back(&at.rows[i].excess);
      result.push_back(&at.rows[i].excess_multiplier);
    }
    for (int i = 0; i < NX; ++i)
      if (limits.is_fixed(i)) result.push_back(&at.nu[i]);
    return result;
  }

  /// All that is zero at the solution.
  Eigen::VectorXd conditions(const Point& at) const
  {
    const Values<NX> value = values(at);
    const Derivatives<Model> derivative = derivatives(at);
    std::vector<double> result;
    for (std::size_t k = 0; k <= intervals; ++k)
    {
      add_stationarity(at, derivative, k, result);
      for (int i = 0; i < NX && k < intervals; ++i) result.push_back(value.residuals.defects[k][i]);
      add_bounds(at, k, result);
    }
    for (std::size_t i = 0; i < limits.rows.size(); ++i) add_row(at.rows[i], limits.rows[i], value.rows[i], result);
    for (int i = 0; i < NX; ++i)
      if (limits.is_fixed(i))
        result.push_back(at.stages[intervals].z[i] - limits.goal[i] - delta * (at.nu[i] - point.nu[i]));
    return Eigen::Map<Eigen::VectorXd>(result.data(), static_cast<Eigen::Index>(result.size()));
  }

  void add_stationarity(const Point& at, const Derivatives<Model>& derivative, std::size_t k,
                        std::vector<double>& result) const
  {
    const auto& stage = at.stages[k];
    Vector<NZ> gradient = derivative.stages[k].gradient - stage.lower + stage.upper;
    if (k < intervals) gradient += derivative.stages[k].jacobian.transpose() * at.stages[k + 1].lambda;
    gradient.head<NX>() -= stage.lambda;
    if (k == intervals) gradient.head<NX>() += at.nu;
    for (std::size_t i = limits.first_row[k]; i < limits.first_row[k + 1]; ++i)
      gradient.head<Model::kRowPoint>() += at.rows[i].multiplier * derivative.rows[i];
    for (int i = k == 0 ? NX : 0; i < (k < intervals ? NZ : NX); ++i) result.push_back(gradient[i]);
  }

  void add_bounds(const Point& at, std::size_t k, std::vector<double>& result) const
  {
    const auto& stage = at.stages[k];
    for (int i = 0; i < NZ; ++i)
    {
      const double lower = limits.bounds[k].lower[i], upper = limits.bounds[k].upper[i];
      if (lower > -kInfinity) result.push_back(stage.lower[i] * (stage.z[i] - lower) - mu);
      if (upper < kInfinity) result.push_back(stage.upper[i] * (upper - stage.z[i]) - mu);
    }
  }

  void add_row(const RowVariables& row, const RowLimit& limit, double g, std::vector<double>& result) const
  {
    result.push_back(g - limit.upper - row.excess + row.slack);
    result.push_back(row.slack * row.multiplier - mu);
    if (!std::isfinite(limit.weight)) return;
    result.push_back(row.excess * row.excess_multiplier - mu);
    result.push_back(limit.weight - row.multiplier - row.excess_multiplier);
  }

  /// Each condition is a polynomial of degree two in each unknown: central differences with a step of 1 are exact.
  Eigen::MatrixXd jacobian() const
  {
    Point at = point;
    const std::vector<double*> variables = unknowns(at);
    const Eigen::Index count = static_cast<Eigen::Index>(variables.size());
    Eigen::MatrixXd result(count, count);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      double& variable = *variables[static_cast<std::size_t>(j)];
      const double value = variable;
      variable = value + 1.0;
      const Eigen::VectorXd after = conditions(at);
      variable = value - 1.0;
      result.col(j) = 0.5 * (after - conditions(at));
      variable = value;
    }
    return result;
  }
};

/// Greatest difference between the structured and the dense step.
double step_error(unsigned seed, double delta)
{
  const Conditions scene(seed, delta);
  const Derivatives<Model> derivatives = scene.derivatives(scene.point);
  NewtonSystem<Model> newton;
  newton.resize(scene.intervals + 1, scene.limits.rows.size());
  newton.assemble(scene.limits, scene.point, derivatives, scene.mu, delta);
  EXPECT_TRUE(newton.factorize(0.0));
  Point step = scene.new_point();
  newton.solve(scene.values(scene.point).residuals, step);

  const Eigen::VectorXd dense = scene.jacobian().fullPivLu().solve(-scene.conditions(scene.point));
  const std::vector<double*> structured = scene.unknowns(step);
  double error = 0.0;
  for (std::size_t i = 0; i < structured.size(); ++i)
    error = std::max(error, std::abs(*structured[i] - dense[static_cast<Eigen::Index>(i)]));
  return error;
}

TEST(NewtonSystem, StepEqualsTheDenseSolutionOfAllOptimalityConditions)
{
  for (unsigned seed = 0; seed < 50; ++seed) EXPECT_LT(step_error(seed, 1e-3), 1e-10) << "seed " << seed;
}

TEST(NewtonSystem, WeakTerminalRegularisationCostsFewDigits)
{
  const double delta = Options().terminal_regularization;
  for (unsigned seed = 0; seed < 50; ++seed) EXPECT_LT(step_error(seed, delta), 1e-7) << "seed " << seed;
}

}  // namespace
}  // namespace fourwis::ocp
