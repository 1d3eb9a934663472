// Problems that are wrong, infeasible, unbounded or not finite: a status, in finite time, and never `solved`.

#include "fourwis_navigation/ocp/solver.h"

#include <gtest/gtest.h>

#include <functional>

#include "models.h"
#include "random_problem.h"
#include "referee.h"

namespace fourwis::ocp
{
namespace
{

constexpr int kIntervals = 10;
const double kNan = std::nan("");

/// A good problem, to be spoilt.
struct ShuttleScene
{
  Problem<2, 2> problem = Shuttle::problem(1.0, 2.0, kIntervals);
  Trajectory<2, 2> guess = Shuttle::guess(1.0, kIntervals);
  Options options;

  ShuttleScene()
  {
    for (int k = 0; k <= kIntervals; ++k) problem.bounds[k].upper[1] = 5.0;
  }

  template <class Model = Shuttle>
  Solution<2, 2> solve(const Model& model = {})
  {
    options.max_iterations = 200;
    Solver<Model> solver;
    return solver.solve(model, problem, guess, options);
  }

  /// The status after spoiling it.
  static Status of(const std::function<void(ShuttleScene&)>& spoil)
  {
    ShuttleScene scene;
    spoil(scene);
    return scene.solve().status;
  }
};

struct RowShuttle : Shuttle
{
  void rows(int, const RowPoint& q, RowValues values) const { values.setConstant(q[0]); }
  void differentiate_rows(int, const RowPoint&, RowMultipliers y, Gradients gradients, RowHessian&) const
  {
    for (int i = 0; i < y.size(); ++i) gradients.col(i) << 1.0, 0.0;
  }
};

TEST(SolverGarbage, UnspoiltProblemIsSolved)
{
  EXPECT_EQ(ShuttleScene::of([](ShuttleScene&) {}), Status::solved);
}

TEST(SolverGarbage, ProblemsThatMakeNoSenseAreInvalid)
{
  const std::function<void(ShuttleScene&)> spoils[] = {
    [](ShuttleScene& s) { s.problem.bounds[3].lower[2] = kNan; },
    [](ShuttleScene& s) { s.problem.bounds[3].upper[0] = kNan; },
    [](ShuttleScene& s) { s.problem.bounds[3].lower[2] = 3.0; },
    [](ShuttleScene& s) { s.problem.bounds[3].lower[2] = kInfinity, s.problem.bounds[3].upper[2] = kInfinity; },
    [](ShuttleScene& s) { s.problem.bounds[3].upper[2] = -kInfinity, s.problem.bounds[3].lower[2] = -kInfinity; },
    [](ShuttleScene& s) { s.problem.initial_state[0] = kNan; },
    [](ShuttleScene& s) { s.problem.initial_state[1] = kInfinity; },
    [](ShuttleScene& s) { s.problem.terminal_state[1] = kInfinity; },
    [](ShuttleScene& s) { s.problem.add_row(10, {kNan, 1.0}); },
    [](ShuttleScene& s) { s.problem.add_row(10, {kInfinity, 1.0}); },
    [](ShuttleScene& s) { s.problem.add_row(10, {1.0, -1.0}); },
    [](ShuttleScene& s) { s.problem.add_row(10, {1.0, 0.0}); },
    [](ShuttleScene& s) { s.problem.add_row(10, {1.0, kNan}); },
    [](ShuttleScene& s) { s.problem.row_counts[2] = 1; },
    [](ShuttleScene& s) { s.problem.row_counts[2] = -1, s.problem.row_counts[3] = 1; },
    [](ShuttleScene& s) { s.problem.row_counts.pop_back(); },
    [](ShuttleScene& s) { s.problem.bounds.pop_back(); },
    [](ShuttleScene& s) { s.problem.bounds.resize(1), s.problem.row_counts.resize(1); },
    [](ShuttleScene& s) { s.problem.bounds.clear(), s.problem.row_counts.clear(); },
    [](ShuttleScene& s) { s.guess.states.pop_back(); },
    [](ShuttleScene& s) { s.guess.controls.clear(); },
  };
  for (const auto& spoil : spoils) EXPECT_EQ(ShuttleScene::of(spoil), Status::invalid_problem) << &spoil - spoils;
}

TEST(SolverGarbage, MultipliersOfAnotherProblemAreInvalid)
{
  ShuttleScene scene;
  Solver<Shuttle> solver;
  const auto multipliers = solver.solve(Shuttle(), scene.problem, scene.guess).multipliers;
  const auto& solution = solver.solve(Shuttle(), Shuttle::problem(1.0, 2.0, 7), Shuttle::guess(1.0, 7), {}, &multipliers);
  EXPECT_EQ(solution.status, Status::invalid_problem);
}

TEST(SolverGarbage, MultipliersThatAreNotFiniteDoNoHarm)
{
  ShuttleScene scene;
  Solver<Shuttle> solver;
  auto multipliers = solver.solve(Shuttle(), scene.problem, scene.guess).multipliers;
  multipliers.lower[2][2] = kNan;
  multipliers.upper[3][2] = kInfinity;
  EXPECT_EQ(solver.solve(Shuttle(), scene.problem, scene.guess, {}, &multipliers).status, Status::solved);
  multipliers.dynamics[4][0] = kNan;
  EXPECT_EQ(solver.solve(Shuttle(), scene.problem, scene.guess, {}, &multipliers).status, Status::not_finite);
}

TEST(SolverGarbage, GuessThatIsNotFiniteIsNotFinite)
{
  EXPECT_EQ(ShuttleScene::of([](ShuttleScene& s) { s.guess.states[4][0] = kNan; }), Status::not_finite);
  EXPECT_EQ(ShuttleScene::of([](ShuttleScene& s) { s.guess.controls[4][1] = kInfinity; }), Status::not_finite);
}

/// Spoils one number of an otherwise good model.
struct SpoiltShuttle : Shuttle
{
  double cost = 0.0, defect = 0.0, gradient = 0.0, jacobian = 0.0, hessian = 0.0;

  void evaluate(int k, const State& x, const Control& u, const State& next, Value& value) const
  {
    Shuttle::evaluate(k, x, u, next, value);
    value.cost += cost;
    value.defect[1] += defect;
  }

  void differentiate(int k, const State& x, const Control& u, const State& lambda, Derivatives& d) const
  {
    Shuttle::differentiate(k, x, u, lambda, d);
    d.gradient[0] += gradient;
    d.jacobian(0, 2) += jacobian;
    d.hessian(3, 3) += hessian;
  }
};

TEST(SolverGarbage, ModelThatIsNotFiniteIsNotFinite)
{
  for (const double bad : {kNan, kInfinity, -kInfinity})
    for (double SpoiltShuttle::*member : {&SpoiltShuttle::cost, &SpoiltShuttle::defect, &SpoiltShuttle::gradient,
                                         &SpoiltShuttle::jacobian, &SpoiltShuttle::hessian})
    {
      SpoiltShuttle model;
      model.*member = bad;
      EXPECT_EQ(ShuttleScene().solve(model).status, Status::not_finite) << bad;
    }
}

/// Has no value beyond p = 0.7: the solver must step back, and cannot arrive.
struct BrokenTrack : Shuttle
{
  void evaluate(int k, const State& x, const Control& u, const State& next, Value& value) const
  {
    Shuttle::evaluate(k, x, u, next, value);
    value.cost += 0.0 * std::log(0.7 - x[0]);
  }
};

TEST(SolverGarbage, StepsToWhereTheModelHasNoValueAreRejected)
{
  ShuttleScene scene;
  for (int k = 0; k <= kIntervals; ++k) scene.guess.states[k][0] *= 0.5;
  const auto solution = scene.solve(BrokenTrack());
  EXPECT_NE(solution.status, Status::invalid_problem);
  EXPECT_NE(solution.status, Status::not_finite);
  for (int k = 0; k < kIntervals; ++k) EXPECT_LT(solution.trajectory.states[k][0], 0.7);
}

TEST(SolverGarbage, ImpossibleProblemsAreNotSolved)
{
  const std::function<void(ShuttleScene&)> spoils[] = {
    [](ShuttleScene& s) { s.problem.terminal_state[0] = 1000.0; },
    [](ShuttleScene& s) { s.problem.bounds[5].lower[0] = 100.0; },
    [](ShuttleScene& s)
    {
      for (auto& bounds : s.problem.bounds) bounds.lower[2] = bounds.upper[2] = 0.0;
    },
  };
  for (const auto& spoil : spoils)
  {
    ShuttleScene scene;
    spoil(scene);
    const auto solution = scene.solve();
    EXPECT_TRUE(solution.status == Status::infeasible || solution.status == Status::stalled)
      << &spoil - spoils << to_string(solution.status);
    EXPECT_GT(solution.statistics.infeasibility, 1e-3);
  }
}

TEST(SolverGarbage, HardRowsThatContradictEachOtherAreInfeasible)
{
  struct Between : Shuttle
  {
    void rows(int, const RowPoint& q, RowValues values) const { values << q[0], -q[0]; }
    void differentiate_rows(int, const RowPoint&, RowMultipliers, Gradients gradients, RowHessian&) const
    {
      gradients << 1.0, -1.0, 0.0, 0.0;
    }
  };
  ShuttleScene scene;
  scene.problem.add_row(5, {0.4});
  scene.problem.add_row(5, {-0.6});
  const auto solution = scene.solve(Between());
  EXPECT_TRUE(solution.status == Status::infeasible || solution.status == Status::stalled) << to_string(solution.status);
  EXPECT_GT(solution.statistics.infeasibility, 0.05);
}

/// min sum of -u: no minimum.
struct Unbounded : ModelBase<1, 1>
{
  void evaluate(int, const State& x, const Control& u, const State& next, Value& value) const
  {
    value.cost = -u[0];
    value.defect = x + u - next;
  }
  void differentiate(int, const State&, const Control&, const State&, Derivatives& d) const
  {
    d.jacobian << 1, 1;
    d.gradient << 0, -1;
  }
};

TEST(SolverGarbage, CostWithoutMinimumIsNotSolved)
{
  Problem<1, 1> problem;
  problem.reset(5);
  Solver<Unbounded> solver;
  EXPECT_NE(solver.solve(Unbounded(), problem, zero_trajectory<1, 1>(5)).status, Status::solved);
}

TEST(SolverGarbage, CoincidingHugeAndOneSidedBoundsAreNoProblem)
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
    void evaluate(int k, const State& x, const Control& u, const State& next, Value& value) const
    {
      Shuttle::evaluate(k, x, u, next, value);
      value.cost = 0.5 * u[0] * u[0];
    }
    void differentiate(int k, const State& x, const Control& u, const State& lambda, Derivatives& d) const
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
  for (int k = 0; k < kIntervals; ++k)  // least effort: a falls linearly from its start to minus that
    EXPECT_NEAR(solution.trajectory.controls[k][0] + solution.trajectory.controls[kIntervals - 1 - k][0], 0.0, 1e-4);
}

TEST(SolverGarbage, OneIntervalIsEnough)
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

TEST(SolverGarbage, RandomNumbersAsAProblemAlwaysEnd)
{
  using Model = RandomModel<3, 2, 4>;
  Solver<Model> solver;
  for (unsigned seed = 0; seed < 300; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const double scale = std::pow(10.0, 8.0 * random());
    Model model(4, 0.0, scale, random);
    Problem<3, 2> problem = random_problem(model, 2, random);
    for (auto& bounds : problem.bounds) bounds.lower *= scale * random(), bounds.upper *= scale * random();
    for (auto& row : problem.rows) row.upper *= scale * random();
    problem.initial_state *= scale;
    Options options;
    options.max_iterations = 60;
    const auto& solution = solver.solve(model, problem, zero_trajectory<3, 2>(4), options);
    EXPECT_LE(solution.statistics.iterations, 60);
    if (solution.status == Status::solved) EXPECT_LE(solution.statistics.error, options.tolerance);
  }
}

TEST(SolverGarbage, OptionsOutOfRangeAreRefusedByName)
{
  const auto refused = [](double Options::*member, double value, const std::string& name)
  {
    ShuttleScene scene;
    scene.options.*member = value;
    try
    {
      scene.solve();
      ADD_FAILURE() << name << " = " << value << " was accepted";
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  };
  for (const double value : {kNan, 0.0, -1.0, kInfinity})
  {
    refused(&Options::tolerance, value, "tolerance");
    refused(&Options::initial_barrier, value, "initial_barrier");
    refused(&Options::barrier_factor, value, "barrier_factor");
    refused(&Options::barrier_power, value, "barrier_power");
    refused(&Options::terminal_regularization, value, "terminal_regularization");
  }
  refused(&Options::barrier_factor, 1.0, "barrier_factor");
}

}  // namespace
}  // namespace fourwis::ocp
