#include "derivative_laws.h"
#include "optimize/ocp_nlp.h"
#include "optimize/segment_problem.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 32;

/// Functions of everything a model may depend on, different in each stage.
struct NonlinearModel : ocp::ModelBase<2, 1, 3>
{
  template <typename Index>
  static double number(Index index)
  {
    return static_cast<double>(index) + 1.0;
  }
  void evaluate(std::size_t k, const State& x, const Control& u, const State& next, Value& value) const
  {
    value.cost = number(k) * std::sin(x[0] * u[0]) + x[1] * x[1];
    value.defect << x[0] * std::exp(u[0]) - next[0], x[0] * x[1] * u[0] + number(k) - 1.0 - next[1];
  }
  void differentiate(std::size_t k, const State& x, const Control& u, const State& lambda, Derivatives& d) const
  {
    const double c = number(k) * std::cos(x[0] * u[0]), s = number(k) * std::sin(x[0] * u[0]), e = std::exp(u[0]);
    d.gradient << u[0] * c, 2.0 * x[1], x[0] * c;
    d.jacobian << e, 0.0, x[0] * e, x[1] * u[0], x[0] * u[0], x[0] * x[1];
    const double mixed = c - x[0] * u[0] * s + lambda[0] * e + lambda[1] * x[1];
    d.hessian << -u[0] * u[0] * s, lambda[1] * u[0], mixed,  //
        lambda[1] * u[0], 2.0, lambda[1] * x[0],             //
        mixed, lambda[1] * x[0], -x[0] * x[0] * s + lambda[0] * x[0] * e;
  }
  double terminal_cost(const State& x) const { return x[0] * x[0] * x[1]; }
  void differentiate_terminal(const State& x, Terminal& terminal) const
  {
    terminal.gradient << 2.0 * x[0] * x[1], x[0] * x[0];
    terminal.hessian << 2.0 * x[1], 2.0 * x[0], 2.0 * x[0], 0.0;
  }
  void rows(std::size_t k, const RowPoint& q, ocp::RowValues values) const
  {
    for (Eigen::Index i = 0; i < values.size(); ++i) values[i] = number(k) * number(i) * q[0] * q[1] + q[2] * q[2];
  }
  void differentiate_rows(std::size_t k, const RowPoint& q, ocp::RowMultipliers y, Gradients gradients,
                          RowHessian& hessian) const
  {
    for (Eigen::Index i = 0; i < y.size(); ++i)
    {
      const double factor = number(k) * number(i);
      gradients.col(i) << factor * q[1], factor * q[0], 2.0 * q[2];
      hessian(0, 1) += y[i] * factor;
      hessian(1, 0) += y[i] * factor;
      hessian(2, 2) += 2.0 * y[i];
    }
  }
};

/// Checks each element of a program at random values of its variables, those of index `positive` modulo `period` being
/// positive.
void expect_exact_derivatives(const Nlp& nlp, int period, int positive)
{
  Random random(kSeed);
  for (std::size_t i = 0; i < nlp.elements.size(); ++i)
    for (int trial = 0; trial < 20; ++trial)
    {
      SCOPED_TRACE(testing::Message() << "seed " << kSeed << " element " << i << " trial " << trial);
      const NlpElement& element = *nlp.elements[i];
      Eigen::VectorXd x(static_cast<Eigen::Index>(element.variables.size()));
      for (Eigen::Index j = 0; j < x.size(); ++j)
        x[j] = random.between(element.variables[static_cast<std::size_t>(j)] % period == positive ? 0.1 : -0.5, 0.5);
      DerivativeCheck(element, random, x).expect_exact(1e-7);
      if (testing::Test::HasFailure()) return;
    }
}

TEST(IpoptDerivatives, OfAnyOptimalControlProblemMeetDifferences)
{
  ocp::Problem<2, 1> problem;
  problem.reset(3);
  for (std::size_t k : {0u, 2u, 3u})
    for (double weight : {5.0, ocp::kInfinity, 7.0}) problem.add_row(k, {1.0, weight});
  const ocp::Trajectory<2, 1> guess{std::vector<ocp::Vector<2>>(4, ocp::Vector<2>::Zero()),
                                    std::vector<ocp::Vector<1>>(3, ocp::Vector<1>::Zero())};
  const NonlinearModel model;
  const OcpNlp<NonlinearModel> program(model, problem, guess);
  ASSERT_EQ(program.nlp().elements.size(), 3u + 1u + 3u);
  ASSERT_EQ(program.nlp().start.size(), 4u * 2u + 3u + 6u);
  expect_exact_derivatives(program.nlp(), 1000, -1);
}

TEST(IpoptDerivatives, OfASegmentsProblemMeetDifferences)
{
  const Robot robot;
  const Polytope square = {{1, 0, 1}, {0, 1, 1}, {-0.6, -0.8, 1}};
  for (Mode mode : kPlannedModes)
  {
    SCOPED_TRACE(to_string(mode));
    const Segment segment = {mode, {{0, 0, 0.2}, {0.2, 0, 0.1}, {0.4, 0, 0.3}}, {0.1, 0.2}, {0.2, 0.2}};
    const Corridor corridor = {{{0.25, 0.1}, {square, square}}, {{-0.25, -0.2}, {square, square}}};
    const MotionLimits limits(robot, mode);
    const auto problem = segment_problem<WheelSpeedRows>({segment, corridor}, robot, OptimizeOptions(), limits, 1.0);
    const OcpNlp<SegmentModel<WheelSpeedRows>> program(problem.model, problem.numbers,
                                                       reference_guess(segment, limits, {0.2, 0.2}));
    expect_exact_derivatives(program.nlp(), 8, 7);
  }
}

}  // namespace
}  // namespace fourwis
