#pragma once

#include <gtest/gtest.h>

#include "fourwis_navigation/ocp/solver.h"

namespace fourwis::ocp
{

/// Whether a solution keeps all constraints and satisfies the first-order conditions with its own multipliers, written
/// down anew from the problem and the model.
template <class Model>
class Referee
{
public:
  static constexpr int NX = Model::kStates, NU = Model::kControls, NQ = Model::kRowPoint, NZ = NX + NU;

  Referee(const Model& model, const Problem<NX, NU>& problem, const Solution<NX, NU>& solution, double tolerance)
    : model_(model),
      problem_(problem),
      x_(solution.trajectory),
      y_(solution.multipliers),
      tolerance_(tolerance)
  {}

  void expect_optimal() const
  {
    EXPECT_EQ(x_.states[0], problem_.initial_state);
    for (int i = 0; i < NX; ++i)
    {
      const double goal = is_fixed(i) ? problem_.terminal_state[i] : x_.states.back()[i];
      EXPECT_NEAR(x_.states.back()[i], goal, tolerance_);
    }
    std::size_t row = 0;
    for (std::size_t k = 0; k <= problem_.intervals(); ++k)
    {
      SCOPED_TRACE(testing::Message() << "stage " << k);
      expect_bounds(k);
      expect_rows(k, row);
      expect_dynamics_and_stationarity(k, row);
      row += static_cast<std::size_t>(problem_.row_counts[k]);
    }
  }

private:
  bool is_fixed(int i) const { return problem_.terminal_fixed[static_cast<std::size_t>(i)]; }

  Vector<NZ> z(std::size_t k) const
  {
    Vector<NZ> result = Vector<NZ>::Zero();
    result.template head<NX>() = x_.states[k];
    if (k < problem_.intervals()) result.template tail<NU>() = x_.controls[k];
    return result;
  }

  bool is_bounded(std::size_t k, int i) const
  {
    if (k == 0) return i >= NX;
    return k < problem_.intervals() || (i < NX && !is_fixed(i));
  }

  void expect_pair(double gap, double multiplier) const
  {
    EXPECT_GE(gap, -tolerance_);
    EXPECT_GE(multiplier, 0.0);
    EXPECT_NEAR(gap * multiplier, 0.0, 10.0 * tolerance_);
  }

  void expect_bounds(std::size_t k) const
  {
    const Vector<NZ> at = z(k);
    for (int i = 0; i < NZ; ++i)
    {
      const double lower = problem_.bounds[k].lower[i], upper = problem_.bounds[k].upper[i];
      if (is_bounded(k, i) && lower > -kInfinity) expect_pair(at[i] - lower, y_.lower[k][i]);
      if (is_bounded(k, i) && upper < kInfinity) expect_pair(upper - at[i], y_.upper[k][i]);
    }
  }

  /// An elastic row that is exceeded has the multiplier `weight`.
  void expect_rows(std::size_t k, std::size_t first) const
  {
    Eigen::VectorXd values(problem_.row_counts[k]);
    model_.rows(k, z(k).template head<NQ>(), {values.data(), values.size()});
    for (Eigen::Index i = 0; i < values.size(); ++i)
    {
      const std::size_t row = first + static_cast<std::size_t>(i);
      const RowLimit& limit = problem_.rows[row];
      const double over = values[i] - limit.upper, y = y_.rows[row];
      if (over < tolerance_)
        expect_pair(-over, y);
      else
        EXPECT_NEAR(y, limit.weight, 10.0 * tolerance_ / over);
      EXPECT_LE(y, limit.weight);
    }
  }

  void expect_dynamics_and_stationarity(std::size_t k, std::size_t first_row) const
  {
    Vector<NZ> gradient = row_gradient(k, first_row) + y_.upper[k] - y_.lower[k];
    if (k > 0) gradient.template head<NX>() -= lambda(k);
    if (k < problem_.intervals())
    {
      typename Model::Value value;
      model_.evaluate(k, x_.states[k], x_.controls[k], x_.states[k + 1], value);
      EXPECT_LT(value.defect.template lpNorm<Eigen::Infinity>(), tolerance_);
      StageDerivatives<NX, NU> d{Matrix<NX, NZ>::Zero(), Vector<NZ>::Zero(), Matrix<NZ, NZ>::Zero()};
      model_.differentiate(k, x_.states[k], x_.controls[k], lambda(k + 1), d);
      gradient += d.gradient + d.jacobian.transpose() * lambda(k + 1);
    }
    else
    {
      TerminalDerivatives<NX> d{Vector<NX>::Zero(), Matrix<NX, NX>::Zero()};
      model_.differentiate_terminal(x_.states[k], d);
      gradient.template head<NX>() += d.gradient + y_.terminal;
    }
    if (k == 0) gradient.template head<NX>().setZero();
    EXPECT_LT(gradient.template lpNorm<Eigen::Infinity>(), 10.0 * tolerance_);
  }

  Vector<NZ> row_gradient(std::size_t k, std::size_t first) const
  {
    const int count = problem_.row_counts[k];
    Eigen::Matrix<double, NQ, Eigen::Dynamic> gradients(NQ, count);
    gradients.setZero();
    const Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(y_.rows.data() + first, count);
    typename Model::RowHessian hessian = Model::RowHessian::Zero();
    model_.differentiate_rows(k, z(k).template head<NQ>(), {y.data(), count}, {gradients.data(), NQ, count}, hessian);
    Vector<NZ> result = Vector<NZ>::Zero();
    result.template head<NQ>() = gradients * y;
    return result;
  }

  Vector<NX> lambda(std::size_t k) const { return y_.dynamics[k - 1]; }

  const Model& model_;
  const Problem<NX, NU>& problem_;
  const Trajectory<NX, NU>& x_;
  const Multipliers<NX, NU>& y_;
  double tolerance_;
};

template <class Model>
void expect_optimal(const Model& model, const Problem<Model::kStates, Model::kControls>& problem,
                    const Solution<Model::kStates, Model::kControls>& solution, double tolerance)
{
  ASSERT_EQ(solution.status, Status::solved) << to_string(solution.status);
  Referee<Model>(model, problem, solution, tolerance).expect_optimal();
}

/// Compares the derivatives of stage k and of its `row_count` rows with central differences.
template <class Model>
void expect_derivatives(const Model& model, std::size_t k, const Vector<Model::kStates + Model::kControls>& z,
                        const Vector<Model::kStates>& lambda, const Eigen::VectorXd& y, double tolerance = 1e-7)
{
  constexpr int NX = Model::kStates, NU = Model::kControls, NQ = Model::kRowPoint, NZ = NX + NU;
  using Wide = Eigen::Matrix<double, NQ, Eigen::Dynamic>;
  const auto value = [&](const Vector<NZ>& at) {
    typename Model::Value result;
    model.evaluate(k, at.template head<NX>(), at.template tail<NU>(), Vector<NX>::Zero(), result);
    return result;
  };
  const auto derivative = [&](const Vector<NZ>& at) {
    StageDerivatives<NX, NU> result{Matrix<NX, NZ>::Zero(), Vector<NZ>::Zero(), Matrix<NZ, NZ>::Zero()};
    model.differentiate(k, at.template head<NX>(), at.template tail<NU>(), lambda, result);
    return result;
  };
  const auto row_values = [&](const Vector<NZ>& at) {
    Eigen::VectorXd result(y.size());
    model.rows(k, at.template head<NQ>(), {result.data(), result.size()});
    return result;
  };
  const auto row_derivative = [&](const Vector<NZ>& at, Matrix<NQ, NQ>& hessian) {
    Wide result = Wide::Zero(NQ, y.size());
    hessian.setZero();
    model.differentiate_rows(k, at.template head<NQ>(), {y.data(), y.size()}, {result.data(), NQ, y.size()}, hessian);
    return result;
  };
  const double step = 1e-5;
  Matrix<NQ, NQ> row_hessian, unused;
  const auto here = derivative(z);
  const Wide row_gradients = row_derivative(z, row_hessian);
  EXPECT_EQ(here.hessian, here.hessian.transpose());
  for (int i = 0; i < NZ; ++i)
  {
    SCOPED_TRACE(testing::Message() << "derivative with respect to variable " << i);
    const Vector<NZ> after = z + step * Vector<NZ>::Unit(i), before = z - step * Vector<NZ>::Unit(i);
    const auto v1 = value(after), v0 = value(before);
    const auto d1 = derivative(after), d0 = derivative(before);
    EXPECT_NEAR(here.gradient[i], (v1.cost - v0.cost) / (2 * step), tolerance);
    EXPECT_LT((here.jacobian.col(i) - (v1.defect - v0.defect) / (2 * step)).norm(), tolerance);
    const Vector<NZ> change = d1.gradient - d0.gradient + (d1.jacobian - d0.jacobian).transpose() * lambda;
    EXPECT_LT((here.hessian.col(i) - change / (2 * step)).norm(), tolerance);
    if (i >= NQ || y.size() == 0) continue;
    const Eigen::VectorXd slope = (row_values(after) - row_values(before)) / (2 * step);
    EXPECT_LT((row_gradients.row(i).transpose() - slope).norm(), tolerance);
    const Wide turn = (row_derivative(after, unused) - row_derivative(before, unused)) / (2 * step);
    EXPECT_LT((row_hessian.col(i) - turn * y).norm(), tolerance);
  }
}

}  // namespace fourwis::ocp
