// How the solver is used again and again: warm starts, the same result each time, kept storage, being stopped.

#include "fourwis_navigation/ocp/solver.h"

#include <gtest/gtest.h>

#include "../support/allocations.h"
#include "models.h"
#include "random_problem.h"
#include "referee.h"

namespace fourwis::ocp
{
namespace
{

constexpr std::size_t kIntervals = 40;
using CarSolution = Solution<4, 3>;

struct CarScene
{
  Car car;
  Problem<4, 3> problem = Car::swing(car, kIntervals, 100.0);
  Trajectory<4, 3> guess = Car::guess(kIntervals);
};

Options warm()
{
  Options options;
  options.initial_barrier = 1e-5;
  return options;
}

void expect_equal(const CarSolution& a, const CarSolution& b)
{
  EXPECT_EQ(a.status, b.status);
  EXPECT_EQ(a.statistics.iterations, b.statistics.iterations);
  EXPECT_EQ(a.statistics.error, b.statistics.error);
  EXPECT_EQ(a.trajectory.states, b.trajectory.states);
  EXPECT_EQ(a.trajectory.controls, b.trajectory.controls);
  EXPECT_EQ(a.multipliers.dynamics, b.multipliers.dynamics);
  EXPECT_EQ(a.multipliers.rows, b.multipliers.rows);
  EXPECT_EQ(a.excess, b.excess);
}

TEST(SolverUse, WarmStartTakesFewerIterations)
{
  CarScene scene;
  Solver<Car> solver;
  const CarSolution cold = solver.solve(scene.car, scene.problem, scene.guess);
  ASSERT_EQ(cold.status, Status::solved);
  scene.problem.initial_state << 0.01, 0.02, -0.01, 0.05;
  const CarSolution cold_again = solver.solve(scene.car, scene.problem, scene.guess);
  const CarSolution primal = solver.solve(scene.car, scene.problem, cold.trajectory, warm());
  expect_optimal(scene.car, scene.problem, primal, 1e-6);
  const CarSolution both = solver.solve(scene.car, scene.problem, cold.trajectory, warm(), &cold.multipliers);
  expect_optimal(scene.car, scene.problem, both, 1e-6);
  EXPECT_LT(primal.statistics.iterations, cold_again.statistics.iterations);
  EXPECT_LT(both.statistics.iterations, primal.statistics.iterations);
  EXPECT_NEAR(primal.statistics.cost, cold_again.statistics.cost, 1e-5);
  EXPECT_NEAR(both.statistics.cost, cold_again.statistics.cost, 1e-5);
}

TEST(SolverUse, SolutionIsAnIdealStartForTheSameProblem)
{
  CarScene scene;
  Solver<Car> solver;
  solver.solve(scene.car, scene.problem, scene.guess);
  const auto& solution = solver.solution();
  solver.solve(scene.car, scene.problem, solution.trajectory, warm(), &solution.multipliers);
  expect_optimal(scene.car, scene.problem, solution, 1e-6);
  EXPECT_LE(solution.statistics.iterations, 5);
}

TEST(SolverUse, SameProblemHasTheSameSolutionBitForBit)
{
  CarScene scene;
  Solver<Car> fresh, used;
  const CarSolution first = fresh.solve(scene.car, scene.problem, scene.guess);
  Problem<4, 3> other = Car::swing(scene.car, 55, kInfinity);
  used.solve(scene.car, other, Car::guess(55));
  expect_equal(first, used.solve(scene.car, scene.problem, scene.guess));
}

TEST(SolverUse, NothingIsAllocatedOnceTheStorageIsThere)
{
  CarScene scene;
  Car car = scene.car;
  const Problem<4, 3> small = Car::swing(car, 25, 100.0);
  const Trajectory<4, 3> small_guess = Car::guess(25);
  Solver<Car> solver;
  solver.solve(scene.car, scene.problem, scene.guess);
  const long before = allocations;
  EXPECT_GT(before, 0);
  solver.solve(car, small, small_guess);
  EXPECT_GT(solver.solution().statistics.iterations, 5);
  solver.solve(scene.car, scene.problem, scene.guess, {}, nullptr, [] { return false; });
  EXPECT_EQ(solver.solution().status, Status::solved);
  EXPECT_EQ(allocations - before, 0);
}

TEST(SolverUse, LooseToleranceStopsEarlierCloseToTheSolution)
{
  CarScene scene;
  Solver<Car> solver;
  const CarSolution tight = solver.solve(scene.car, scene.problem, scene.guess);
  Options options;
  options.tolerance = 1e-2;
  const CarSolution loose = solver.solve(scene.car, scene.problem, scene.guess, options);
  EXPECT_EQ(loose.status, Status::solved);
  EXPECT_LE(loose.statistics.error, 1e-2);
  EXPECT_LT(loose.statistics.iterations, tight.statistics.iterations);
  EXPECT_NEAR(loose.statistics.cost, tight.statistics.cost, 0.3);
}

TEST(SolverUse, StopsWhenInterrupted)
{
  CarScene scene;
  Solver<Car> solver;
  for (const int patience : {0, 1, 4})
  {
    int polls = 0;
    const auto interrupted = [&] { return polls++ == patience; };
    const auto& solution = solver.solve(scene.car, scene.problem, scene.guess, {}, nullptr, interrupted);
    EXPECT_EQ(solution.status, Status::interrupted);
    EXPECT_EQ(solution.statistics.iterations, patience);
  }
}

TEST(SolverUse, StopsAtTheIterationLimitWithTheLastIterate)
{
  CarScene scene;
  Solver<Car> solver;
  for (const int limit : {0, 1, 5})
  {
    Options options;
    options.max_iterations = limit;
    const auto& solution = solver.solve(scene.car, scene.problem, scene.guess, options);
    EXPECT_EQ(solution.status, Status::iteration_limit);
    EXPECT_EQ(solution.statistics.iterations, limit);
    EXPECT_EQ(solution.trajectory.states.size(), kIntervals + 1u);
    EXPECT_GT(solution.statistics.error, options.tolerance);
  }
}

}  // namespace
}  // namespace fourwis::ocp
