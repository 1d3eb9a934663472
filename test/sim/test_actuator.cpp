#include "fourwis_navigation/sim/actuator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/random.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 51;
constexpr double kStep = 0.001;

TEST(Actuator, FollowsASmallStepAsAFirstOrderLag)
{
  Actuator actuator({10.0, 1e6, 0.05});
  actuator.set_target(1.0);
  for (int k = 1; k <= 500; ++k)
  {
    actuator.step(kStep);
    ASSERT_NEAR(actuator.value(), 1.0 - std::exp(-k * kStep / 0.05), 1e-9);
  }
}

TEST(Actuator, WithoutLagIsThereAsSoonAsItsRateAllows)
{
  Actuator actuator({10.0, 2.0, 0.0});
  actuator.set_target(-0.5);
  for (int k = 0; k < 249; ++k) actuator.step(kStep);
  EXPECT_NEAR(actuator.value(), -0.498, 1e-9);
  actuator.step(kStep);
  actuator.step(kStep);
  EXPECT_EQ(actuator.value(), -0.5);
}

TEST(Actuator, LagsBehindARampByItsTimeConstant)
{
  Actuator actuator({10.0, 3.0, 0.05});
  for (int k = 0; k < 2000; ++k)
  {
    actuator.set_target(1.0 * k * kStep);
    actuator.step(kStep);
  }
  EXPECT_NEAR(actuator.target() - actuator.value(), 0.05, 0.001);
}

TEST(Actuator, NeverIsFasterThanItsRateNorBeyondItsRangeNorOvershoots)
{
  Random random(kSeed);
  for (int trial = 0; trial < 100; ++trial)
  {
    const Actuator::Limits limits{random.between(0.5, 3.0), random.between(0.1, 10.0), random.between(0.0, 0.2)};
    Actuator actuator(limits);
    for (int k = 0; k < 200; ++k)
    {
      if (k % 40 == 0) actuator.set_target(random.between(-4.0, 4.0));
      const double before = actuator.value(), step = random.between(0.0005, 0.01);
      actuator.step(step);
      const double after = actuator.value(), reachable = std::clamp(actuator.target(), -limits.range, limits.range);
      ASSERT_LE(std::abs(after - before), limits.rate * step + 1e-12);
      ASSERT_LE(std::abs(after), limits.range);
      ASSERT_LE(std::abs(reachable - after), std::abs(reachable - before) + 1e-12);
      ASSERT_GE((reachable - after) * (reachable - before), -1e-12) << "seed " << kSeed << ", trial " << trial;
    }
  }
}

TEST(Actuator, GoesOnFromAValueForcedUponIt)
{
  Actuator actuator({1.0, 1.0, 0.0});
  actuator.set_target(0.5);
  actuator.set_value(-3.0);
  EXPECT_EQ(actuator.value(), -1.0);
  actuator.step(0.1);
  EXPECT_NEAR(actuator.value(), -0.9, 1e-12);
}

}  // namespace
}  // namespace fourwis
