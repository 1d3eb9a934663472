// Problems without a solution, and some with one that is hard to see: a status in finite time, `solved` only with one.

#include "fourwis_navigation/ocp/solver.h"

#include <gtest/gtest.h>

#include "../support/fuzz_rounds.h"
#include "random_problem.h"
#include "shuttle_scene.h"

namespace fourwis::ocp
{
namespace
{

/// Has no value beyond p = 0.7: the solver must step back, and cannot arrive.
struct BrokenTrack : Shuttle
{
  void evaluate(std::size_t k, const State& x, const Control& u, const State& next, Value& value) const
  {
    Shuttle::evaluate(k, x, u, next, value);
    value.cost += 0.0 * std::log(0.7 - x[0]);
  }
};

TEST(SolverHard, StepsToWhereTheModelHasNoValueAreRejected)
{
  ShuttleScene scene;
  for (std::size_t k = 0; k <= ShuttleScene::kIntervals; ++k) scene.guess.states[k][0] *= 0.5;
  const auto solution = scene.solve(BrokenTrack());
  EXPECT_NE(solution.status, Status::invalid_problem);
  EXPECT_NE(solution.status, Status::not_finite);
  for (std::size_t k = 0; k < ShuttleScene::kIntervals; ++k) EXPECT_LT(solution.trajectory.states[k][0], 0.7);
}

TEST(SolverHard, ImpossibleProblemsAreNotSolved)
{
  const ShuttleScene::Change spoils[] = {
      [](ShuttleScene& s) { s.problem.terminal_state[0] = 1000.0; },
      [](ShuttleScene& s) { s.problem.bounds[5].lower[0] = 100.0; },
      [](ShuttleScene& s) {
        for (auto& bounds : s.problem.bounds) bounds.lower[2] = bounds.upper[2] = 0.0;
      },
  };
  for (const auto& spoil : spoils)
  {
    const auto solution = ShuttleScene::solved_after(spoil);
    EXPECT_TRUE(solution.status == Status::infeasible || solution.status == Status::stalled)
        << &spoil - spoils << to_string(solution.status);
    EXPECT_GT(solution.statistics.infeasibility, 1e-3);
  }
}

TEST(SolverHard, HardRowsThatContradictEachOtherAreInfeasible)
{
  struct Between : Shuttle
  {
    void rows(std::size_t, const RowPoint& q, RowValues values) const { values << q[0], -q[0]; }
    void differentiate_rows(std::size_t, const RowPoint&, RowMultipliers, Gradients gradients, RowHessian&) const
    {
      gradients << 1.0, -1.0, 0.0, 0.0;
    }
  };
  ShuttleScene scene;
  scene.problem.add_row(5, {0.4});
  scene.problem.add_row(5, {-0.6});
  const auto solution = scene.solve(Between());
  EXPECT_TRUE(solution.status == Status::infeasible || solution.status == Status::stalled)
      << to_string(solution.status);
  EXPECT_GT(solution.statistics.infeasibility, 0.05);
}

/// min sum of -u_1: no minimum.
struct Unbounded : ModelBase<2, 2>
{
  void evaluate(std::size_t, const State& x, const Control& u, const State& next, Value& value) const
  {
    value.cost = -u[0];
    value.defect = x + u - next;
  }
  void differentiate(std::size_t, const State&, const Control&, const State&, Derivatives& d) const
  {
    d.jacobian << 1, 0, 1, 0,  //
        0, 1, 0, 1;
    d.gradient << 0, 0, -1, 0;
  }
};

TEST(SolverHard, CostWithoutMinimumIsNotSolved)
{
  Problem<2, 2> problem;
  problem.reset(5);
  Solver<Unbounded> solver;
  EXPECT_NE(solver.solve(Unbounded(), problem, zero_trajectory<2, 2>(5)).status, Status::solved);
}

TEST(SolverHard, CoincidingHugeAndOneSidedBoundsAreNoProblem)
{
  ShuttleScene scene;
  for (auto& bounds : scene.problem.bounds)
  {
    bounds.lower[0] = -1e20;
    bounds.upper[0] = 1e20;
    bounds.lower[1] = -kInfinity;
    bounds.lower[3] = bounds.upper[3] = 0.2;
  }
  for (auto& bounds : scene.problem.bounds) bounds.lower[2] = -3.0, bounds.upper[2] = 3.0;
  struct Effort : Shuttle
  {
    void evaluate(std::size_t k, const State& x, const Control& u, const State& next, Value& value) const
    {
      Shuttle::evaluate(k, x, u, next, value);
      value.cost = 0.5 * u[0] * u[0];
    }
    void differentiate(std::size_t k, const State& x, const Control& u, const State& lambda, Derivatives& d) const
    {
      Shuttle::differentiate(k, x, u, lambda, d);
      d.gradient << 0, 0, u[0], 0;
      d.hessian(2, 2) += 1;
    }
  };
  Solver<Effort> solver;
  const auto& solution = solver.solve(Effort(), scene.problem, scene.guess);
  ASSERT_EQ(solution.status, Status::solved);
  for (const auto& u : solution.trajectory.controls) EXPECT_NEAR(u[1], 0.2, 1e-7);
  // Least effort: a falls linearly from its start to minus that.
  const auto& controls = solution.trajectory.controls;
  for (std::size_t k = 0; k < controls.size(); ++k)
    EXPECT_NEAR(controls[k][0] + controls[controls.size() - 1 - k][0], 0.0, 1e-4);
}

TEST(SolverHard, AccuracyBeyondRoundingIsAcceptable)
{
  ShuttleScene scene;
  scene.options.tolerance = 1e-17;
  const auto solution = scene.solve();
  EXPECT_EQ(solution.status, Status::acceptable) << to_string(solution.status);
  EXPECT_LT(solution.statistics.error, scene.options.acceptable_tolerance);
  EXPECT_NEAR(solution.statistics.cost, std::sqrt(2.0), 1e-6);
}

TEST(SolverHard, OneIntervalIsEnough)
{
  ShuttleScene scene;
  scene.problem = Shuttle::problem(1.0, 2.0, 1);
  scene.problem.terminal_fixed = {true, false};
  scene.guess = Shuttle::guess(1.0, 1);
  scene.problem.bounds[0].upper[3] = 3.0;
  const auto solution = scene.solve();
  ASSERT_EQ(solution.status, Status::solved);
  EXPECT_NEAR(solution.statistics.cost, 1.0, 1e-5);  // 1/2 a h^2 = 1 m
}

TEST(SolverHard, RandomNumbersAsAProblemAlwaysEnd)
{
  using Model = RandomModel<3, 2, 2, 1>;
  Solver<Model> solver;
  int solved = 0, unsolved = 0;
  for (unsigned seed = 0; seed < static_cast<unsigned>(fuzz_rounds(300)); ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const double scale = std::pow(10.0, 8.0 * random.unit());
    const Model model(4, 0.0, scale, random);
    Problem<3, 2> problem = random_problem(model, 2, random);
    for (auto& bounds : problem.bounds)
    {
      bounds.lower.array() -= scale;
      bounds.upper.array() += scale;
    }
    for (auto& row : problem.rows) row.upper += scale * random.unit();
    problem.initial_state *= scale;
    Options options;
    options.max_iterations = 60;
    const auto& solution = solver.solve(model, problem, zero_trajectory<3, 2>(4), options);
    ASSERT_NE(solution.status, Status::invalid_problem);
    EXPECT_LE(solution.statistics.iterations, 60);
    EXPECT_EQ(solution.status == Status::solved, solution.statistics.error <= options.tolerance);
    ++(solution.status == Status::solved ? solved : unsolved);
  }
  EXPECT_GT(solved, 50);
  EXPECT_GT(unsolved, 50);
}

}  // namespace
}  // namespace fourwis::ocp
