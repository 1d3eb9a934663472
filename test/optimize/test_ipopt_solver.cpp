#include "optimize/ipopt_solver.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

namespace fourwis
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Rosenbrock's function with a flatter valley: c = (x - 1)^2 + 10 (y - x^2)^2, g = x^2 + y^2
class Rosenbrock : public NlpElement
{
public:
  Rosenbrock(int x, int y, double radius) : NlpElement({x, y}, 1)
  {
    row_lower[0] = -kInfinity;
    row_upper[0] = radius * radius;
  }

  double evaluate(const Eigen::VectorXd& z, Eigen::Ref<Eigen::VectorXd> rows) const override
  {
    const double x = z[0], bend = z[1] - x * x;
    rows[0] = z.squaredNorm();
    return (x - 1.0) * (x - 1.0) + 10.0 * bend * bend;
  }

  void differentiate(const Eigen::VectorXd& z, double s, const Eigen::VectorXd& y, Derivatives& d) const override
  {
    const double x = z[0], bend = z[1] - x * x;
    d.gradient << 2.0 * (x - 1.0) - 40.0 * x * bend, 20.0 * bend;
    d.jacobian << 2.0 * x, 2.0 * z[1];
    d.hessian << s * (2.0 - 40.0 * bend + 80.0 * x * x), -s * 40.0 * x, -s * 40.0 * x, s * 20.0;
    d.hessian.diagonal().array() += 2.0 * y[0];
  }
};

/// Two such functions that share y, in discs around the origin.
Nlp two_rosenbrock(double radius = 10.0)
{
  Nlp nlp;
  for (double start : {-1.0, 0.5, 2.0}) nlp.add_variable(-kInfinity, kInfinity, start);
  nlp.elements.push_back(std::make_unique<Rosenbrock>(0, 1, radius));
  nlp.elements.push_back(std::make_unique<Rosenbrock>(2, 1, radius));
  return nlp;
}

void expect_refused(const Nlp& nlp)
{
  const NlpResult result = solve_on_ipopt(nlp, {}, {});
  EXPECT_EQ(result.status, NlpStatus::invalid_problem);
  EXPECT_EQ(result.iterations, 0);
}

TEST(IpoptSolver, FindsTheLeastSumOfElementsThatShareVariables)
{
  const NlpResult result = solve_on_ipopt(two_rosenbrock(), {}, {});
  ASSERT_EQ(result.status, NlpStatus::solved);
  EXPECT_GT(result.iterations, 0);
  for (double value : result.x) EXPECT_NEAR(value, 1.0, 1e-6);
}

TEST(IpoptSolver, KeepsRowsAndBoundsAndFixedVariables)
{
  NlpResult result = solve_on_ipopt(two_rosenbrock(0.5), {}, {});
  ASSERT_EQ(result.status, NlpStatus::solved);
  EXPECT_NEAR(std::hypot(result.x[0], result.x[1]), 0.5, 1e-5);

  Nlp bounded = two_rosenbrock();
  bounded.upper[1] = 0.25;
  bounded.start[2] = 0.75;
  bounded.fix(2);
  result = solve_on_ipopt(bounded, {}, {});
  ASSERT_EQ(result.status, NlpStatus::solved);
  EXPECT_NEAR(result.x[1], 0.25, 1e-5);
  EXPECT_EQ(result.x[2], 0.75);
}

TEST(IpoptSolver, SaysWhyItDidNotSolve)
{
  Nlp contradictory = two_rosenbrock(0.5);
  contradictory.lower[0] = 1.0;
  EXPECT_EQ(solve_on_ipopt(contradictory, {}, {}).status, NlpStatus::infeasible);

  IpoptOptions hasty;
  hasty.max_iterations = 2;
  EXPECT_EQ(solve_on_ipopt(two_rosenbrock(), hasty, {}).status, NlpStatus::iteration_limit);

  const std::atomic<bool> cancelled{true};
  EXPECT_EQ(solve_on_ipopt(two_rosenbrock(), {}, Interrupt(&cancelled)).status, NlpStatus::interrupted);
  const Interrupt late(nullptr, Interrupt::Clock::now());
  EXPECT_EQ(solve_on_ipopt(two_rosenbrock(), {}, late).status, NlpStatus::interrupted);
}

TEST(IpoptSolver, RefusesWhatIsNoProgram)
{
  expect_refused({});
  for (double bad : {kNaN, kInfinity})
  {
    Nlp nlp = two_rosenbrock();
    nlp.start[1] = bad;
    expect_refused(nlp);
    nlp = two_rosenbrock();
    nlp.lower[1] = bad;
    expect_refused(nlp);
    nlp = two_rosenbrock();
    nlp.upper[1] = -bad;
    expect_refused(nlp);
  }
  Nlp crossed = two_rosenbrock();
  crossed.lower[0] = 2.0;
  crossed.upper[0] = 1.0;
  expect_refused(crossed);
  expect_refused(two_rosenbrock(kNaN));
}

TEST(IpoptSolver, ServesSeveralThreads)
{
  std::vector<NlpResult> results(4);
  std::vector<std::thread> threads;
  for (NlpResult& result : results)
    threads.emplace_back([&result] {
      for (int i = 0; i < 10; ++i) result = solve_on_ipopt(two_rosenbrock(0.5), {}, {});
    });
  for (std::thread& thread : threads) thread.join();
  const NlpResult alone = solve_on_ipopt(two_rosenbrock(0.5), {}, {});
  for (const NlpResult& result : results)
  {
    EXPECT_EQ(result.status, NlpStatus::solved);
    EXPECT_EQ(result.x, alone.x);
    EXPECT_EQ(result.iterations, alone.iterations);
  }
}

TEST(IpoptSolver, NamesEveryStatus)
{
  for (NlpStatus status : {NlpStatus::solved, NlpStatus::acceptable, NlpStatus::iteration_limit, NlpStatus::infeasible,
                           NlpStatus::failed, NlpStatus::interrupted, NlpStatus::invalid_problem})
    EXPECT_STRNE(to_string(status), "");
  EXPECT_TRUE(is_solved(NlpStatus::acceptable));
  EXPECT_FALSE(is_solved(NlpStatus::iteration_limit));
}

}  // namespace
}  // namespace fourwis
