#include <numeric>

#include "derivative_laws.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "optimize/paper_discs.h"
#include "optimize/paper_step.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 31;
constexpr std::size_t kSteps = 7;

/// Differences cannot resolve weights of 1e6.
PaperOptions light_options()
{
  PaperOptions options;
  options.penalty = 3.0;
  return options;
}

std::vector<int> first_indices(int count)
{
  std::vector<int> indices(static_cast<std::size_t>(count));
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

struct PaperDerivatives : testing::TestWithParam<Mode>
{
  /// Visits random values of `count` variables, the `duration`-th being T.
  template <typename Visit>
  void for_points(int count, int duration, Visit visit)
  {
    for (int trial = 0; trial < 200; ++trial)
    {
      SCOPED_TRACE(testing::Message() << "seed " << kSeed << " trial " << trial);
      Eigen::VectorXd x(count);
      for (double& value : x) value = random.between(-1.0, 1.0);
      x[duration] = random.between(0.5, 3.0);
      visit(x);
      if (HasFailure()) return;
    }
  }

  const Robot robot;
  const EulerDynamics dynamics{robot, GetParam()};
  Random random{kSeed};
};

TEST_P(PaperDerivatives, OfAStepMeetDifferences)
{
  const PaperStep step(dynamics, light_options(), kSteps, first_indices(18));
  for_points(18, 7, [&](const Eigen::VectorXd& x) { DerivativeCheck(step, random, x).expect_exact(1e-7); });
}

TEST_P(PaperDerivatives, OfDiscsMeetDifferences)
{
  const PaperDiscs discs(0.25, light_options(), kSteps, Box{0, 0, 1, 1}, Box{0, 0, 1, 1}, first_indices(8));
  for_points(8, 3, [&](const Eigen::VectorXd& x) { DerivativeCheck(discs, random, x).expect_exact(1e-7); });
}

TEST_P(PaperDerivatives, AStepIsOneOfEulersRule)
{
  for_points(8, 7, [&](const Eigen::VectorXd& x) {
    const EulerDynamics::State next = dynamics.next(x);
    const Twist twist = body_twist(robot, GetParam(), x[3], x[4]);
    const Pose moved = compose({x[0], x[1], x[2]}, {twist.vx * x[7], twist.vy * x[7], twist.omega * x[7]});
    EXPECT_NEAR(next[0], moved.x, 1e-12);
    EXPECT_NEAR(next[1], moved.y, 1e-12);
    EXPECT_NEAR(wrap_angle(next[2] - moved.theta), 0.0, 1e-12);
    EXPECT_DOUBLE_EQ(next[3], x[3] + x[5] * x[7]);
    EXPECT_DOUBLE_EQ(next[4], x[4] + x[6] * x[7]);
  });
}

INSTANTIATE_TEST_SUITE_P(Modes, PaperDerivatives, testing::ValuesIn(kPlannedModes),
                         [](const auto& given) { return std::string(to_string(given.param)); });

}  // namespace
}  // namespace fourwis
