#pragma once

#include <algorithm>
#include <cmath>
#include "../support/random.h"
#include "fourwis_navigation/ocp/solver.h"

namespace fourwis::ocp
{

/// Numbers in [-1, 1].
template <int Rows, int Columns>
Matrix<Rows, Columns> random_matrix(Random& random)
{
  return Matrix<Rows, Columns>::NullaryExpr([&](Eigen::Index, Eigen::Index) { return random.unit(); });
}

/// Quadratic costs, dynamics and rows with random coefficients:
///   l = 1/2 z' Q z + q' z,   F_i = A_i z + b_i + 1/2 bend z' C z,   g_j = a_j' r + 1/2 bend r' D r,
/// D being another one for wide rows.
template <int NX, int NU, int NR, int NW = 0>
struct RandomModel : ModelBase<NX, NU, NR, NW>
{
  using Base = ModelBase<NX, NU, NR, NW>;
  using typename Base::Control;
  using typename Base::Derivatives;
  using typename Base::Gradients;
  using typename Base::RowHessian;
  using typename Base::RowPoint;
  using typename Base::State;
  using typename Base::Terminal;
  using typename Base::Value;
  static constexpr int NZ = NX + NU, NQ = Base::kRowPoint;
  static constexpr int kMostRows = 3;

  struct Stage
  {
    Matrix<NZ, NZ> Q, C;
    Vector<NZ> q;
    Matrix<NX, NZ> A;
    Vector<NX> b;
    std::vector<Vector<NQ>> a;
    Matrix<NQ, NQ> D, wide_D;
  };
  std::vector<Stage> stages;  ///< N + 1
  double bend = 0.0;

  /// `convexity` is added to the diagonal of Q, whose other part has eigenvalues of both signs.
  RandomModel(std::size_t intervals, double convexity, double bend_of_constraints, Random& random)
    : bend(bend_of_constraints)
  {
    for (std::size_t k = 0; k <= intervals; ++k)
    {
      Stage stage;
      stage.Q = random_matrix<NZ, NZ>(random);
      stage.C = random_matrix<NZ, NZ>(random);
      stage.q = random_matrix<NZ, 1>(random);
      stage.A = 0.7 * random_matrix<NX, NZ>(random);
      stage.b = random_matrix<NX, 1>(random);
      stage.D = random_matrix<NQ, NQ>(random);
      stage.Q = (stage.Q + stage.Q.transpose()).eval() / 2.0 + convexity * Matrix<NZ, NZ>::Identity();
      stage.C = (stage.C + stage.C.transpose()).eval() / 2.0;
      stage.D = (stage.D + stage.D.transpose()).eval() / 2.0;
      const int narrow = k == intervals ? std::min(NR, NX) : NR;
      stage.D.rightCols(NQ - narrow).setZero();
      stage.D.bottomRows(NQ - narrow).setZero();
      for (int i = 0; i < kMostRows; ++i)
      {
        stage.a.push_back(random_matrix<NQ, 1>(random));
        if (k == intervals || i >= NW) stage.a.back().tail(NQ - narrow).setZero();
      }
      stage.wide_D = stage.D;
      if (NW > 0 && k < intervals) stage.wide_D += Matrix<NQ, NQ>::Identity();
      stages.push_back(stage);
    }
  }

  const Matrix<NQ, NQ>& curvature(std::size_t k, Eigen::Index row) const
  {
    return row < NW ? stages[k].wide_D : stages[k].D;
  }

  static Vector<NZ> join(const State& x, const Control& u)
  {
    Vector<NZ> z;
    z << x, u;
    return z;
  }

  void evaluate(std::size_t k, const State& x, const Control& u, const State& next, Value& value) const
  {
    const Stage& s = stages[k];
    const Vector<NZ> z = join(x, u);
    value.cost = 0.5 * z.dot(s.Q * z) + s.q.dot(z);
    value.defect = s.A * z + s.b - next;
    value.defect.array() += 0.5 * bend * z.dot(s.C * z);
  }

  void differentiate(std::size_t k, const State& x, const Control& u, const State& lambda,
                     Derivatives& derivatives) const
  {
    const Stage& s = stages[k];
    const Vector<NZ> z = join(x, u);
    derivatives.gradient = s.Q * z + s.q;
    derivatives.jacobian = s.A + bend * Vector<NX>::Ones() * (s.C * z).transpose();
    derivatives.hessian = s.Q + bend * lambda.sum() * s.C;
  }

  double terminal_cost(const State& x) const
  {
    return 0.5 * x.dot(stages.back().Q.template topLeftCorner<NX, NX>() * x) +
           stages.back().q.template head<NX>().dot(x);
  }

  void differentiate_terminal(const State& x, Terminal& terminal) const
  {
    terminal.hessian = stages.back().Q.template topLeftCorner<NX, NX>();
    terminal.gradient = terminal.hessian * x + stages.back().q.template head<NX>();
  }

  void rows(std::size_t k, const RowPoint& r, RowValues values) const
  {
    for (Eigen::Index i = 0; i < values.size(); ++i)
      values[i] = stages[k].a[static_cast<std::size_t>(i)].dot(r) + 0.5 * bend * r.dot(curvature(k, i) * r);
  }

  void differentiate_rows(std::size_t k, const RowPoint& r, RowMultipliers y, Gradients gradients,
                          RowHessian& hessian) const
  {
    for (Eigen::Index i = 0; i < y.size(); ++i)
    {
      gradients.col(i) = stages[k].a[static_cast<std::size_t>(i)] + bend * (curvature(k, i) * r);
      hessian += bend * y[i] * curvature(k, i);
    }
  }
};

/// The motion of a model under given controls.
template <class Model>
Trajectory<Model::kStates, Model::kControls> roll_out(const Model& model, const Vector<Model::kStates>& start,
                                                      const std::vector<Vector<Model::kControls>>& controls)
{
  Trajectory<Model::kStates, Model::kControls> result{{start}, controls};
  for (std::size_t k = 0; k < controls.size(); ++k)
  {
    typename Model::Value value;
    model.evaluate(k, result.states[k], controls[k], Vector<Model::kStates>::Zero(), value);
    result.states.push_back(value.defect);
  }
  return result;
}

/// Random bounds (about every other one missing), rows (elastic and hard) and terminal components, which all hold
/// strictly on a random motion of the model.
template <int NX, int NU, int NR, int NW>
Problem<NX, NU> random_problem(const RandomModel<NX, NU, NR, NW>& model, int rows_per_stage, Random& random)
{
  const std::size_t intervals = model.stages.size() - 1;
  std::vector<Vector<NU>> controls;
  for (std::size_t k = 0; k < intervals; ++k) controls.push_back(0.5 * random_matrix<NU, 1>(random));
  const Trajectory<NX, NU> inside = roll_out(model, random_matrix<NX, 1>(random), controls);
  Problem<NX, NU> problem;
  problem.reset(intervals);
  problem.initial_state = inside.states.front();
  problem.terminal_state = inside.states.back();
  for (std::size_t i = 0; i < NX; i += 2) problem.terminal_fixed[i] = true;
  for (std::size_t k = 0; k <= intervals; ++k)
  {
    const Vector<NX + NU> z = model.join(inside.states[k], k < intervals ? controls[k] : Vector<NU>::Zero());
    for (int i = 0; i < NX + NU; ++i)
    {
      if (random.unit() > 0.0) problem.bounds[k].lower[i] = z[i] - 0.6 + 0.5 * random.unit();
      if (random.unit() > 0.0) problem.bounds[k].upper[i] = z[i] + 0.6 + 0.5 * random.unit();
    }
    Eigen::VectorXd values(rows_per_stage);
    model.rows(k, z.template head<RandomModel<NX, NU, NR, NW>::NQ>(), {values.data(), rows_per_stage});
    for (int i = 0; i < rows_per_stage; ++i)
      problem.add_row(
          k, {values[i] + 0.6 + 0.5 * random.unit(), random.unit() > 0.0 ? 10.0 + 5.0 * random.unit() : kInfinity});
  }
  return problem;
}

/// All states and controls zero.
template <int NX, int NU>
Trajectory<NX, NU> zero_trajectory(std::size_t intervals)
{
  return {std::vector<Vector<NX>>(intervals + 1, Vector<NX>::Zero()),
          std::vector<Vector<NU>>(intervals, Vector<NU>::Zero())};
}

}  // namespace fourwis::ocp
