#include "fourwis_navigation/model/pose.h"

#include <gtest/gtest.h>

#include <limits>

#include "../support/random.h"

namespace fourwis
{
namespace
{

constexpr double kAccuracy = 1e-12;
constexpr unsigned kSeed = 1;

void expect_near(const Pose& a, const Pose& b)
{
  EXPECT_NEAR(a.x, b.x, kAccuracy);
  EXPECT_NEAR(a.y, b.y, kAccuracy);
  EXPECT_NEAR(a.theta, b.theta, kAccuracy);
}

TEST(WrapAngle, LiesInTheHalfOpenInterval)
{
  Random random(kSeed);
  for (int k = 0; k < 10000; ++k)
  {
    const double angle = random.between(-100.0, 100.0), wrapped = wrap_angle(angle);
    ASSERT_GT(wrapped, -M_PI) << angle;
    ASSERT_LE(wrapped, M_PI) << angle;
  }
}

TEST(WrapAngle, IsTheSameDirection)
{
  Random random(kSeed);
  for (int k = 0; k < 10000; ++k)
  {
    const double angle = random.between(-100.0, 100.0), wrapped = wrap_angle(angle);
    ASSERT_NEAR(std::cos(wrapped), std::cos(angle), kAccuracy) << angle;
    ASSERT_NEAR(std::sin(wrapped), std::sin(angle), kAccuracy) << angle;
  }
}

TEST(WrapAngle, LeavesWrappedAnglesAlone)
{
  for (double angle : {0.0, 1.0, -1.0, M_PI, -3.14159, 1e-300}) EXPECT_EQ(wrap_angle(angle), angle);
}

TEST(WrapAngle, PrefersPlusPi)
{
  for (int odd = -9; odd <= 9; odd += 2) EXPECT_NEAR(std::abs(wrap_angle(odd * M_PI)), M_PI, kAccuracy) << odd;
  EXPECT_EQ(wrap_angle(-M_PI), M_PI);
  EXPECT_EQ(wrap_angle(M_PI), M_PI);
}

TEST(Compose, IsUndoneByRelativeTo)
{
  Random random(kSeed);
  for (int k = 0; k < 1000; ++k)
  {
    const Pose base = random.pose(10.0), pose = random.pose(10.0);
    SCOPED_TRACE(text(base) + " and " + text(pose));
    expect_near(relative_to(base, compose(base, pose)), pose);
    expect_near(compose(base, relative_to(base, pose)), pose);
  }
}

TEST(Compose, IsAssociative)
{
  Random random(kSeed);
  for (int k = 0; k < 1000; ++k)
  {
    const Pose a = random.pose(10.0), b = random.pose(10.0), c = random.pose(10.0);
    expect_near(compose(compose(a, b), c), compose(a, compose(b, c)));
  }
}

TEST(Compose, HasTheOriginAsIdentity)
{
  const Pose pose = {1.5, -2.0, 0.7};
  expect_near(compose(pose, {}), pose);
  expect_near(compose({}, pose), pose);
}

TEST(Compose, TurnsCounterClockwise)
{
  expect_near(compose({1.0, 2.0, M_PI_2}, {3.0, 0.0, 0.5}), {1.0, 5.0, M_PI_2 + 0.5});
}

TEST(Distance, DoesNotDependOnTheFrame)
{
  Random random(kSeed);
  for (int k = 0; k < 1000; ++k)
  {
    const Pose base = random.pose(10.0), a = random.pose(10.0), b = random.pose(10.0);
    ASSERT_NEAR(distance(compose(base, a), compose(base, b)), distance(a, b), kAccuracy);
    ASSERT_EQ(distance(a, b), distance(b, a));
  }
  EXPECT_EQ(distance({0.0, 0.0, 1.0}, {3.0, 4.0, -1.0}), 5.0);
}

TEST(IsFinite, LooksAtEveryNumber)
{
  EXPECT_TRUE(is_finite({1.0, -2.0, 3.0}));
  const double infinity = std::numeric_limits<double>::infinity();
  for (double bad : {std::nan(""), infinity, -infinity})
  {
    EXPECT_FALSE(is_finite({bad, 0.0, 0.0}));
    EXPECT_FALSE(is_finite({0.0, bad, 0.0}));
    EXPECT_FALSE(is_finite({0.0, 0.0, bad}));
  }
}

}  // namespace
}  // namespace fourwis
