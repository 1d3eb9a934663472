#include "can/bridge/axis_scale.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include "../../support/random.h"

namespace fourwis::can
{
namespace
{

AxisOptions random_axis(Random& random)
{
  AxisOptions axis;
  axis.counts_per_turn = random.between(100.0, 1e5);
  axis.gear_ratio = random.between(1.0, 100.0);
  axis.reversed = random.chance(0.5);
  axis.offset = random.angle();
  return axis;
}

TEST(AxisScale, ATurnOfTheSteeringColumnIsTheTurnsOfItsMotor)
{
  AxisOptions axis;
  axis.counts_per_turn = 4096.0;
  axis.gear_ratio = 50.0;
  axis.offset = 0.5;
  const AxisScale scale = AxisScale::steering(axis);
  EXPECT_EQ(scale.to_counts(0.5), 0);
  EXPECT_EQ(scale.to_counts(0.5 + 2.0 * M_PI), 204800);
  EXPECT_EQ(scale.to_rate_counts(M_PI), 102400);
  EXPECT_NEAR(scale.to_position(-102400), 0.5 - M_PI, 1e-12);
  EXPECT_NEAR(scale.to_rate(204800), 2.0 * M_PI, 1e-12);
}

TEST(AxisScale, ATurnOfTheWheelRollsItsCircumference)
{
  AxisOptions axis;
  axis.counts_per_turn = 1000.0;
  axis.gear_ratio = 10.0;
  axis.reversed = true;
  axis.offset = 0.5;  // means nothing here
  const AxisScale scale = AxisScale::driving(axis, 0.2);
  EXPECT_EQ(scale.to_rate_counts(2.0 * M_PI * 0.2), -10000);
  EXPECT_EQ(scale.to_counts(2.0 * M_PI * 0.2), -10000);
  EXPECT_NEAR(scale.to_rate(10000), -2.0 * M_PI * 0.2, 1e-12);
}

TEST(AxisScale, ThereAndBackIsTheSameWithinHalfACount)
{
  Random random(1);
  for (int i = 0; i < 10000; ++i)
  {
    const AxisOptions axis = random_axis(random);
    for (const AxisScale& scale : {AxisScale::steering(axis), AxisScale::driving(axis, random.between(0.05, 0.5))})
    {
      const double unit = 0.5000001 / std::abs(scale.counts_per_unit());
      const double position = random.between(-3.0, 3.0);
      EXPECT_NEAR(scale.to_position(scale.to_counts(position)), position, unit);
      EXPECT_NEAR(scale.to_rate(scale.to_rate_counts(position)), position, unit);
      const std::int32_t counts = random.whole(-1000000, 1000000);
      EXPECT_EQ(scale.to_counts(scale.to_position(counts)), counts);
      EXPECT_EQ(scale.to_rate_counts(scale.to_rate(counts)), counts);
    }
  }
}

TEST(AxisScale, CountsThatDoNotFitStopAtTheEndOfTheirRange)
{
  using Limits = std::numeric_limits<std::int32_t>;
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(saturated_counts(inf), Limits::max());
  EXPECT_EQ(saturated_counts(-inf), Limits::min());
  EXPECT_EQ(saturated_counts(2147483646.6), Limits::max());
  EXPECT_EQ(saturated_counts(-2147483648.6), Limits::min());
  EXPECT_EQ(saturated_counts(1e300), Limits::max());
  EXPECT_EQ(saturated_counts(std::nan("")), 0);
  EXPECT_EQ(saturated_counts(-1.5), -2);
}

}  // namespace
}  // namespace fourwis::can
