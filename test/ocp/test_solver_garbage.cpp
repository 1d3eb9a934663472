// Problems that make no sense and numbers that are not finite have a status of their own; bad options throw.

#include "fourwis_navigation/ocp/solver.h"

#include <gtest/gtest.h>

#include "shuttle_scene.h"

namespace fourwis::ocp
{
namespace
{

const double kNan = std::nan("");

TEST(SolverGarbage, UnspoiltProblemIsSolved)
{
  EXPECT_EQ(ShuttleScene().solve().status, Status::solved);
}

TEST(SolverGarbage, ProblemsThatMakeNoSenseAreInvalid)
{
  const ShuttleScene::Change spoils[] = {
      [](ShuttleScene& s) { s.problem.bounds[3].lower[2] = kNan; },
      [](ShuttleScene& s) { s.problem.bounds[3].upper[0] = kNan; },
      [](ShuttleScene& s) { s.problem.bounds[3].lower[2] = 3.0; },
      [](ShuttleScene& s) { s.problem.bounds[3].lower[2] = kInfinity, s.problem.bounds[3].upper[2] = kInfinity; },
      [](ShuttleScene& s) { s.problem.bounds[3].upper[2] = -kInfinity, s.problem.bounds[3].lower[2] = -kInfinity; },
      [](ShuttleScene& s) { s.problem.initial_state[0] = kNan; },
      [](ShuttleScene& s) { s.problem.initial_state[1] = kInfinity; },
      [](ShuttleScene& s) { s.problem.terminal_state[1] = kInfinity; },
      [](ShuttleScene& s) {
        s.problem.add_row(10, {kNan, 1.0});
      },
      [](ShuttleScene& s) {
        s.problem.add_row(10, {kInfinity, 1.0});
      },
      [](ShuttleScene& s) {
        s.problem.add_row(10, {1.0, -1.0});
      },
      [](ShuttleScene& s) {
        s.problem.add_row(10, {1.0, 0.0});
      },
      [](ShuttleScene& s) {
        s.problem.add_row(10, {1.0, kNan});
      },
      [](ShuttleScene& s) { s.problem.row_counts[2] = 1; },
      [](ShuttleScene& s) { s.problem.row_counts[2] = -1, s.problem.row_counts[3] = 1; },
      [](ShuttleScene& s) { s.problem.row_counts.pop_back(); },
      [](ShuttleScene& s) { s.problem.bounds.pop_back(); },
      [](ShuttleScene& s) { s.problem.bounds.resize(1), s.problem.row_counts.resize(1); },
      [](ShuttleScene& s) { s.problem.bounds.clear(), s.problem.row_counts.clear(); },
      [](ShuttleScene& s) { s.guess.states.pop_back(); },
      [](ShuttleScene& s) { s.guess.controls.clear(); },
  };
  for (const auto& spoil : spoils)
    EXPECT_EQ(ShuttleScene::solved_after(spoil).status, Status::invalid_problem) << &spoil - spoils;
}

TEST(SolverGarbage, MultipliersOfAnotherProblemAreInvalid)
{
  ShuttleScene scene;
  Solver<Shuttle> solver;
  const auto multipliers = solver.solve(Shuttle(), scene.problem, scene.guess).multipliers;
  const auto& solution =
      solver.solve(Shuttle(), Shuttle::problem(1.0, 2.0, 7), Shuttle::guess(1.0, 7), {}, &multipliers);
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
  const ShuttleScene::Change spoils[] = {
      [](ShuttleScene& s) { s.guess.states[4][0] = kNan; },
      [](ShuttleScene& s) { s.guess.controls[4][1] = kInfinity; },
  };
  for (const auto& spoil : spoils) EXPECT_EQ(ShuttleScene::solved_after(spoil).status, Status::not_finite);
}

/// Spoils one number of an otherwise good model.
struct SpoiltShuttle : Shuttle
{
  double cost = 0.0, defect = 0.0, gradient = 0.0, jacobian = 0.0, hessian = 0.0;

  void evaluate(std::size_t k, const State& x, const Control& u, const State& next, Value& value) const
  {
    Shuttle::evaluate(k, x, u, next, value);
    value.cost += cost;
    value.defect[1] += defect;
  }

  void differentiate(std::size_t k, const State& x, const Control& u, const State& lambda, Derivatives& d) const
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

TEST(SolverGarbage, OptionsOutOfRangeAreRejectedByName)
{
  const auto rejected = [](double Options::*member, double value, const std::string& name) {
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
    rejected(&Options::tolerance, value, "tolerance");
    rejected(&Options::initial_barrier, value, "initial_barrier");
    rejected(&Options::barrier_factor, value, "barrier_factor");
    rejected(&Options::barrier_power, value, "barrier_power");
    rejected(&Options::terminal_regularization, value, "terminal_regularization");
  }
  rejected(&Options::barrier_factor, 1.0, "barrier_factor");
}

}  // namespace
}  // namespace fourwis::ocp
