#pragma once

#include <optional>

#include "fourwis_navigation/ocp/filter.h"
#include "fourwis_navigation/ocp/merit.h"
#include "fourwis_navigation/ocp/model.h"
#include "fourwis_navigation/ocp/newton_system.h"
#include "fourwis_navigation/ocp/optimality.h"
#include "fourwis_navigation/ocp/options.h"
#include "fourwis_navigation/ocp/problem.h"
#include "fourwis_navigation/ocp/step_length.h"

namespace fourwis::ocp
{

/// What the solver returns. Trajectory and multipliers are the last iterate, except for
/// `invalid_problem` and `not_finite`, where they say nothing.
template <int NX, int NU>
struct Solution
{
  Status status = Status::invalid_problem;
  Statistics statistics;
  Trajectory<NX, NU> trajectory;
  Multipliers<NX, NU> multipliers;
  std::vector<double> excess;  ///< max(0, g_i - c_i) of each row
};

/// Primal-dual interior-point method for discrete-time optimal-control problems
///
///   minimise    sum_{k<N} l_k(x_k, u_k) + l_N(x_N) + sum_i w_i e_i
///   subject to  F_k(x_k, u_k) - x_{k+1} = 0,  x_0 given,  components of x_N given,
///               lower_k <= (x_k, u_k) <= upper_k,
///               g_i(x_k, u_k) - e_i <= c_i,  e_i >= 0   (e_i = 0 for hard rows),
///
/// whose Newton steps are found by a Riccati recursion, so that an iteration takes a time linear in N. Example: the
/// least time to move by 1 m from rest to rest with |a| <= 2 m/s^2, the interval length h being a control.
///
///   struct Shuttle : ocp::ModelBase<2, 2>  // x = (p, v), u = (a, h)
///   {
///     void evaluate(std::size_t, const State& x, const Control& u, const State& next, Value& value) const
///     {
///       value.cost = u[1];
///       value.defect << x[0] + u[1] * x[1] + 0.5 * u[0] * u[1] * u[1] - next[0], x[1] + u[0] * u[1] - next[1];
///     }
///     void differentiate(std::size_t, const State& x, const Control& u, const State& lambda, Derivatives& d) const
///     {
///       const double a = u[0], h = u[1];
///       d.jacobian << 1, h, 0.5 * h * h, x[1] + a * h,  //
///                     0, 1, h, a;
///       d.gradient[3] = 1;
///       d.hessian(1, 3) = d.hessian(3, 1) = lambda[0];
///       d.hessian(2, 3) = d.hessian(3, 2) = lambda[0] * h + lambda[1];
///       d.hessian(3, 3) = lambda[0] * a;
///     }
///   };
///
///   ocp::Problem<2, 2> problem;
///   problem.reset(20);
///   problem.terminal_state << 1, 0;
///   problem.terminal_fixed = {true, true};
///   for (auto& bounds : problem.bounds)
///   {
///     bounds.lower.tail<2>() << -2, 0.01;
///     bounds.upper.tail<2>() << 2, 1;
///   }
///   ocp::Trajectory<2, 2> guess;
///   guess.states.assign(21, {0, 0});
///   guess.controls.assign(20, {0, 0.1});
///   ocp::Solver<Shuttle> solver;
///   const auto& solution = solver.solve(Shuttle(), problem, guess);  // solution.statistics.cost = 2 sqrt(1 / 2)
///
/// The solver keeps its storage from call to call: once it has seen the greatest N and number of rows, it allocates
/// nothing. One thread at a time. Deterministic.
template <class Model>
class Solver
{
public:
  static constexpr int NX = Model::kStates;
  static constexpr int NU = Model::kControls;
  using Problem = ocp::Problem<NX, NU>;
  using Trajectory = ocp::Trajectory<NX, NU>;
  using Multipliers = ocp::Multipliers<NX, NU>;
  using Solution = ocp::Solution<NX, NU>;

  /// Solves from `guess`, whose x_0 is replaced by the problem's and which is moved into the interior of the bounds.
  /// For a warm start give a small `options.initial_barrier`, and the multipliers of a similar problem where they are
  /// known. Both may be parts of an earlier solution of this solver. The result is valid until the next call.
  const Solution& solve(const Model& model, const Problem& problem, const Trajectory& guess,
                        const Options& options = {}, const Multipliers* multipliers = nullptr,
                        const Interrupted& interrupted = {});

  const Solution& solution() const { return solution_; }

private:
  using Point = Iterate<NX, NU>;
  using Aim = typename NewtonSystem<Model>::Aim;

  void set_up(const Problem& problem);
  void start(const Trajectory& guess, const Multipliers* multipliers);
  Status run(const Interrupted& interrupted);
  void reduce_barrier(const Optimality& optimality);
  Status failure(Status status) const;

  // These take a step, or say why there is none.
  std::optional<Status> advance();
  std::optional<Status> reduce_violation();

  /// tau of the fraction-to-the-boundary rule.
  double boundary_fraction() const { return std::max(0.99, 1.0 - mu_); }

  bool factorize();
  bool search_line();
  bool search_feasibility();
  bool try_correction(const SearchPoint& start, double alpha);
  void try_step(const Point& step, double alpha);
  Filter::Verdict judge(const SearchPoint& start, double alpha) const;
  void accept(const Point& step, double primal, double dual);
  void restart_multipliers();
  void report();
  void report_rows();

  // The problem while it is being solved.
  const Model* model_ = nullptr;
  Options options_;
  Constraints<NX, NU> constraints_;

  Point current_, trial_;
  Values<NX> values_, trial_values_;
  Merit merit_, trial_merit_;
  Derivatives<Model> derivatives_;
  NewtonSystem<Model> newton_;
  Point step_, correction_;
  Residuals<NX> corrected_residuals_;
  std::vector<double> row_multipliers_;
  Filter filter_;
  double mu_ = 0.0;
  double regularization_ = 0.0;         ///< the last one that was needed
  double forced_regularization_ = 0.0;  ///< where the step without any made no progress
  int stalled_ = 0;                     ///< iterations in a row without progress

  Solution solution_;
};

}  // namespace fourwis::ocp

#include "fourwis_navigation/ocp/solver_implementation.h"
#include "fourwis_navigation/ocp/solver_steps.h"
