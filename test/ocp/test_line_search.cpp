// What a step is measured by: filter, merit, distances from bounds, and the point where it all starts.

#include <gtest/gtest.h>

#include <cmath>

#include "fourwis_navigation/ocp/filter.h"
#include "fourwis_navigation/ocp/merit.h"
#include "fourwis_navigation/ocp/step_length.h"
#include "random_point.h"

namespace fourwis::ocp
{
namespace
{

using Verdict = Filter::Verdict;

Filter filter_around(double violation)
{
  Filter filter;
  filter.reset(violation);
  return filter;
}

TEST(Filter, AcceptsLessViolationOrLessBarrierAndNothingElse)
{
  const Filter filter = filter_around(1.0);
  const SearchPoint start{1.0, 5.0, -1e-9};
  EXPECT_EQ(filter.judge(start, 1.0, 0.9, 6.0), Verdict::makes_progress);
  EXPECT_EQ(filter.judge(start, 1.0, 1.1, 4.9), Verdict::makes_progress);
  EXPECT_EQ(filter.judge(start, 1.0, 1.0, 5.0), Verdict::rejected);
  EXPECT_EQ(filter.judge(start, 1.0, 1.1, 5.1), Verdict::rejected);
}

TEST(Filter, DemandsArmijosDecreaseWhereTheConstraintsAreAlmostMet)
{
  const Filter filter = filter_around(0.0);
  const SearchPoint start{1e-9, 5.0, -1.0};
  EXPECT_EQ(filter.judge(start, 1.0, 1e-9, 4.5), Verdict::reduces_barrier);
  EXPECT_EQ(filter.judge(start, 1.0, 0.0, 5.1), Verdict::rejected);
  const SearchPoint uphill{1e-9, 5.0, 1.0};
  EXPECT_EQ(filter.judge(uphill, 1.0, 0.0, 5.1), Verdict::makes_progress);
}

TEST(Filter, RefusesToReturnToWhatItContains)
{
  Filter filter = filter_around(1.0);
  const SearchPoint start{2.0, 5.0, -1e-9};
  EXPECT_EQ(filter.judge(start, 1.0, 1.5, 4.0), Verdict::makes_progress);
  filter.add(1.5, 4.0);
  EXPECT_EQ(filter.judge(start, 1.0, 1.5, 4.0), Verdict::rejected);
  EXPECT_EQ(filter.judge(start, 1.0, 1.6, 4.1), Verdict::rejected);
  EXPECT_EQ(filter.judge(start, 1.0, 1.4, 4.1), Verdict::makes_progress);
  EXPECT_EQ(filter.judge(start, 1.0, 1.6, 3.9), Verdict::makes_progress);
  filter.clear();
  EXPECT_EQ(filter.judge(start, 1.0, 1.6, 4.1), Verdict::makes_progress);
}

TEST(Filter, RefusesNumbersThatAreNotFiniteAndGreatViolations)
{
  const Filter filter = filter_around(1.0);
  const SearchPoint start{1.0, 5.0, -1e-9};
  EXPECT_EQ(filter.judge(start, 1.0, std::nan(""), 4.0), Verdict::rejected);
  EXPECT_EQ(filter.judge(start, 1.0, 0.5, std::nan("")), Verdict::rejected);
  EXPECT_EQ(filter.judge(start, 1.0, 0.5, -kInfinity), Verdict::rejected);
  EXPECT_EQ(filter.judge(start, 1.0, 3.9, 4.0), Verdict::makes_progress);
  EXPECT_EQ(filter.judge(start, 1.0, 4.1, 4.0), Verdict::rejected);
}

TEST(LogSum, EqualsTheSumOfLogarithms)
{
  Random random(1);
  for (const double decades : {0.1, 3.0, 30.0, 150.0})
  {
    LogSum fast;
    double slow = 0.0;
    for (int i = 0; i < 1000; ++i)
    {
      const double value = std::pow(10.0, decades * random.unit());
      fast.add(value);
      slow += std::log(value);
    }
    EXPECT_NEAR(fast.value(), slow, 1e-12 * 1000 * decades);
  }
}

TEST(LogSum, IsNotFiniteForWhatIsNotPositive)
{
  for (const double bad : {0.0, -1.0, std::nan("")})
  {
    LogSum sum;
    sum.add(2.0);
    sum.add(bad);
    sum.add(-3.0);
    EXPECT_FALSE(std::isfinite(sum.value())) << bad;
  }
}

/// A direction in which all variables change.
RandomPoint::Point random_step(RandomPoint& scene)
{
  RandomPoint::Point step = scene.new_point();
  for (std::size_t k = 0; k <= scene.intervals; ++k)
  {
    auto& stage = step.stages[k];
    stage.z = random_matrix<RandomPoint::NZ, 1>(scene.random);
    stage.lambda = random_matrix<RandomPoint::NX, 1>(scene.random);
    if (k == 0) stage.z.head<RandomPoint::NX>().setZero();
    if (k == scene.intervals) stage.z.tail<RandomPoint::NU>().setZero();
    for (int i = 0; i < RandomPoint::NZ; ++i)
    {
      stage.lower[i] = scene.point.stages[k].lower[i] > 0.0 ? 4.0 * scene.random.unit() : 0.0;
      stage.upper[i] = scene.point.stages[k].upper[i] > 0.0 ? 4.0 * scene.random.unit() : 0.0;
    }
  }
  for (std::size_t i = 0; i < step.rows.size(); ++i)
  {
    const double dy = 2.0 * scene.random.unit();
    step.rows[i] = {2.0 * scene.random.unit(), scene.point.rows[i].excess > 0.0 ? 2.0 * scene.random.unit() : 0.0, dy,
                    -dy};
  }
  step.nu.setZero();
  return step;
}

TEST(Merit, SlopeIsTheDerivativeOfTheBarrierFunctionAlongTheStep)
{
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    RandomPoint scene(seed);
    const RandomPoint::Point step = random_step(scene);
    const double mu = 0.3, h = 1e-6;
    const auto barrier_at = [&](double alpha) {
      RandomPoint::Point at = scene.point;
      move_primal(scene.point, step, alpha, at);
      return merit(scene.limits, at, scene.values(at)).barrier(mu);
    };
    const double difference = (barrier_at(h) - barrier_at(-h)) / (2.0 * h);
    EXPECT_NEAR(slope(scene.limits, scene.point, scene.derivatives(scene.point), step, mu), difference, 1e-5);
  }
}

/// Least of value_after / value_before over all that must stay positive, for the steps alpha.
StepLengths least_ratios(const RandomPoint& scene, const RandomPoint::Point& step, const StepLengths& alpha)
{
  StepLengths least{kInfinity, kInfinity};
  const auto primal = [&](double value, double change) {
    least.primal = std::min(least.primal, (value + alpha.primal * change) / value);
  };
  const auto dual = [&](double value, double change) {
    least.dual = std::min(least.dual, (value + alpha.dual * change) / value);
  };
  for (std::size_t k = 0; k <= scene.intervals; ++k)
    for (int i = 0; i < RandomPoint::NZ; ++i)
    {
      const auto &at = scene.point.stages[k], &change = step.stages[k];
      const auto& bounds = scene.limits.bounds[k];
      if (bounds.lower[i] > -kInfinity)
      {
        primal(at.z[i] - bounds.lower[i], change.z[i]);
        dual(at.lower[i], change.lower[i]);
      }
      if (bounds.upper[i] < kInfinity)
      {
        primal(bounds.upper[i] - at.z[i], -change.z[i]);
        dual(at.upper[i], change.upper[i]);
      }
    }
  for (std::size_t i = 0; i < step.rows.size(); ++i)
  {
    const auto &at = scene.point.rows[i], &change = step.rows[i];
    primal(at.slack, change.slack);
    dual(at.multiplier, change.multiplier);
    if (at.excess == 0.0) continue;
    primal(at.excess, change.excess);
    dual(at.excess_multiplier, change.excess_multiplier);
  }
  return least;
}

TEST(StepLength, IsTheLongestThatKeepsAFractionOfEachDistance)
{
  const double tau = 0.9;
  for (unsigned seed = 0; seed < 50; ++seed)
  {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    RandomPoint scene(seed);
    const RandomPoint::Point step = random_step(scene);
    const StepLengths lengths = fraction_to_boundary(scene.limits, scene.point, step, tau);
    const StepLengths least = least_ratios(scene, step, lengths);
    EXPECT_LE(lengths.primal, 1.0);
    EXPECT_LE(lengths.dual, 1.0);
    const double expected = 1.0 - tau;
    EXPECT_NEAR(least.primal, lengths.primal < 1.0 ? expected : std::max(expected, least.primal), 1e-12);
    EXPECT_NEAR(least.dual, lengths.dual < 1.0 ? expected : std::max(expected, least.dual), 1e-12);
  }
}

TEST(Start, ElasticRowIsMetAndCentralHoweverFarItIsExceeded)
{
  for (const double over : {-1e3, -1.0, -1e-6, 0.0, 1e-6, 1.0, 1e3})
    for (const double mu : {1.0, 1e-2, 1e-7})
    {
      SCOPED_TRACE(testing::Message() << "over " << over << " mu " << mu);
      const RowVariables row = detail::central_elastic_row(over, 100.0, mu);
      EXPECT_NEAR(row.excess - row.slack, over, 1e-9 * std::max(1.0, std::abs(over)));
      EXPECT_NEAR(row.slack * row.multiplier, mu, 1e-9 * mu);
      EXPECT_NEAR(row.excess * row.excess_multiplier, mu, 1e-9 * mu);
      EXPECT_NEAR(row.multiplier + row.excess_multiplier, 100.0, 1e-9);
    }
}

TEST(Start, PushesInsideOfBoundsOnEitherSideOrBoth)
{
  EXPECT_EQ(detail::moved_inside(0.3, 0.0, 1.0, 0.01), 0.3);
  EXPECT_EQ(detail::moved_inside(-2.0, 0.0, 1.0, 0.001), 0.001);
  EXPECT_EQ(detail::moved_inside(2.0, 0.0, 1.0, 0.5), 0.99);
  EXPECT_EQ(detail::moved_inside(2.0, -kInfinity, 1.0, 0.5), 0.5);
  EXPECT_EQ(detail::moved_inside(2.0, -kInfinity, kInfinity, 0.5), 2.0);
  EXPECT_EQ(detail::moved_inside(50.0, 100.0, kInfinity, 0.01), 101.0);
}

TEST(Start, MultipliersGivenAreKeptNearTheCentralPath)
{
  EXPECT_DOUBLE_EQ(detail::starting_multiplier(0.5, 0.1, 0.0), 0.2);
  EXPECT_DOUBLE_EQ(detail::starting_multiplier(0.5, 0.1, std::nan("")), 0.2);
  EXPECT_DOUBLE_EQ(detail::starting_multiplier(0.5, 0.1, 7.0), 7.0);
  EXPECT_DOUBLE_EQ(detail::starting_multiplier(0.5, 0.1, 1e9), 200.0);
  EXPECT_EQ(detail::starting_multiplier(kInfinity, 0.1, 7.0), 0.0);
}

}  // namespace
}  // namespace fourwis::ocp
