// What the solver returns is optimal: linear-quadratic, convex and non-convex problems, judged by the optimality
// conditions written down anew (referee.h) and by optima that are known.

#include "fourwis_navigation/ocp/solver.h"

#include <gtest/gtest.h>

#include <numeric>

#include "models.h"
#include "random_problem.h"
#include "referee.h"

namespace fourwis::ocp
{
namespace
{

/// The states given remain.
Problem<4, 2> without_inequalities(const Problem<4, 2>& problem)
{
  Problem<4, 2> result = problem;
  result.reset(problem.intervals());
  result.terminal_fixed = problem.terminal_fixed;
  return result;
}

template <int NX, int NU>
double sum_of(const Trajectory<NX, NU>& trajectory, int control)
{
  double sum = 0.0;
  for (const auto& u : trajectory.controls) sum += u[control];
  return sum;
}

using Quadratic = RandomModel<4, 2, 5>;

TEST(Models, DerivativesAreThoseOfTheValues)
{
  Random random(3);
  Car car;
  car.half_planes = {{0.6, 0.8}, {-1.0, 0.0}, {0.0, -1.0}};
  for (int i = 0; i < 20; ++i)
  {
    expect_derivatives(Shuttle(), 0, random_matrix<4, 1>(random), random_matrix<2, 1>(random), Eigen::VectorXd());
    expect_derivatives(car, 1, random_matrix<7, 1>(random), random_matrix<4, 1>(random), random_matrix<3, 1>(random));
    const Quadratic quadratic(2, 1.0, 0.5, random);
    expect_derivatives(quadratic, 1, random_matrix<6, 1>(random), random_matrix<4, 1>(random),
                       random_matrix<3, 1>(random));
  }
}

TEST(Solver, LinearQuadraticProblemTakesOneStep)
{
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Quadratic model(6, 5.0, 0.0, random);
    Problem<4, 2> problem = without_inequalities(random_problem(model, 0, random));
    problem.terminal_fixed.fill(false);
    Solver<Quadratic> solver;
    const auto& solution = solver.solve(model, problem, zero_trajectory<4, 2>(6));
    EXPECT_EQ(solution.statistics.iterations, 1);
    expect_optimal(model, problem, solution, 1e-10);
  }
}

TEST(Solver, TerminalStateIsReachedWithAnyRegularisation)
{
  for (const double regularization : {1e-5, 1e-7, 1e-9})
    for (unsigned seed = 0; seed < 20; ++seed)
    {
      SCOPED_TRACE(testing::Message() << "seed " << seed << " regularisation " << regularization);
      Random random(seed);
      const Quadratic model(6, 5.0, 0.0, random);
      const Problem<4, 2> problem = without_inequalities(random_problem(model, 0, random));
      Options options;
      options.terminal_regularization = regularization;
      Solver<Quadratic> solver;
      expect_optimal(model, problem, solver.solve(model, problem, zero_trajectory<4, 2>(6), options), 1e-6);
    }
}

TEST(Solver, ConvexProblemsWithBoundsAndRowsAreSolved)
{
  Solver<Quadratic> solver;
  for (unsigned seed = 0; seed < 100; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Quadratic model(8, 3.0, 0.0, random);
    const Problem<4, 2> problem = random_problem(model, 3, random);
    expect_optimal(model, problem, solver.solve(model, problem, zero_trajectory<4, 2>(8)), 1e-6);
  }
}

TEST(Solver, CurvedNonConvexProblemsAreSolved)
{
  Solver<Quadratic> solver;
  int solved = 0, regularized = 0;
  for (unsigned seed = 0; seed < 200; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Random random(seed);
    const Quadratic model(8, 0.5, 0.1, random);
    Problem<4, 2> problem = random_problem(model, 3, random);
    for (auto& bounds : problem.bounds)
    {
      bounds.lower = bounds.lower.cwiseMax(-5.0);
      bounds.upper = bounds.upper.cwiseMin(5.0);
    }
    const auto& solution = solver.solve(model, problem, zero_trajectory<4, 2>(8));
    regularized += solution.statistics.regularizations > 0;
    if (solution.status != Status::solved) continue;
    ++solved;
    expect_optimal(model, problem, solution, 1e-6);
  }
  EXPECT_GE(solved, 190);
  EXPECT_GT(regularized, 50);
}

TEST(Solver, LeastTimeBetweenTwoPointsIsThatOfTheBangBangMotion)
{
  Solver<Shuttle> solver;
  Options options;
  options.tolerance = 1e-8;
  for (const double distance : {0.1, 1.0, 7.0})
    for (const double acceleration : {0.5, 2.0})
    {
      SCOPED_TRACE(testing::Message() << distance << " m with " << acceleration << " m/s^2");
      const Problem<2, 2> problem = Shuttle::problem(distance, acceleration, 20);
      const auto& solution = solver.solve(Shuttle(), problem, Shuttle::guess(distance, 20), options);
      expect_optimal(Shuttle(), problem, solution, 1e-6);
      EXPECT_NEAR(solution.statistics.cost, 2.0 * std::sqrt(distance / acceleration), 1e-5);
      EXPECT_NEAR(sum_of(solution.trajectory, 1), solution.statistics.cost, 1e-9);
    }
}

TEST(Solver, CarSwingsBetweenTwoWallsHardOrElastic)
{
  constexpr std::size_t intervals = 40;
  Car car;
  Solver<Car> solver;
  double cost[2];
  for (const double weight : {kInfinity, 100.0})
  {
    SCOPED_TRACE(testing::Message() << "weight " << weight);
    const Problem<4, 3> problem = Car::swing(car, intervals, weight);
    const auto& solution = solver.solve(car, problem, Car::guess(intervals));
    expect_optimal(car, problem, solution, 1e-6);
    EXPECT_LT(solution.statistics.elastic_violation, 1e-6);
    EXPECT_GT(*std::max_element(solution.multipliers.rows.begin(), solution.multipliers.rows.end()), 1e-3)
        << "no wall hit";
    cost[weight < kInfinity] = solution.statistics.cost;
  }
  EXPECT_NEAR(cost[0], cost[1], 1e-5);
}

TEST(Solver, RowsThatContradictEachOtherAreExceededByAsLittleAsPossible)
{
  constexpr std::size_t intervals = 40;
  Car car;
  Problem<4, 3> problem = Car::swing(car, intervals, 100.0);
  // y <= 0.3 and y >= 0.5 at one knot: for every y in between the two are exceeded by 0.2 together.
  problem.rows[2 * 19].upper = 0.3;
  problem.rows[2 * 19 + 1].upper = -0.5;
  Options options;
  options.tolerance = 1e-8;
  Solver<Car> solver;
  const auto& solution = solver.solve(car, problem, Car::guess(intervals), options);
  expect_optimal(car, problem, solution, 1e-6);
  EXPECT_NEAR(std::accumulate(solution.excess.begin(), solution.excess.end(), 0.0), 0.2, 1e-5);
  EXPECT_EQ(solution.statistics.elastic_violation, *std::max_element(solution.excess.begin(), solution.excess.end()));
  EXPECT_GE(solution.statistics.elastic_violation, 0.1 - 1e-6);
}

TEST(Solver, ActiveBoundHasTheMultiplierThatTheCostLosesByIt)
{
  const auto least_time = [](double acceleration) {
    Options options;
    options.tolerance = 1e-9;
    Solver<Shuttle> solver;
    const auto& solution =
        solver.solve(Shuttle(), Shuttle::problem(1.0, acceleration, 10), Shuttle::guess(1.0, 10), options);
    double multipliers = 0.0;
    for (std::size_t k = 0; k < 10; ++k)
      multipliers += solution.multipliers.lower[k][2] + solution.multipliers.upper[k][2];
    return std::pair(solution.statistics.cost, multipliers);
  };
  const double step = 1e-3;
  EXPECT_NEAR(least_time(2.0).second, (least_time(2.0 - step).first - least_time(2.0 + step).first) / (2.0 * step),
              1e-4);
}

}  // namespace
}  // namespace fourwis::ocp
