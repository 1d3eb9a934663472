#include "fourwis_navigation/sim/encoders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "../support/random.h"

namespace fourwis
{
namespace
{

constexpr int kSeed = 53;

WheelMotion any(Random& random)
{
  WheelMotion wheels;
  for (double& angle : wheels.angle) angle = random.angle();
  for (double& speed : wheels.speed) speed = random.between(-1.0, 1.0);
  return wheels;
}

TEST(Encoders, WithoutStepsAndNoiseSayTheTruth)
{
  Encoders encoders({0.0, 0.0, 0.0, 0.0}, kSeed);
  Random random(kSeed);
  const WheelMotion truth = any(random);
  encoders.measure(truth);
  EXPECT_EQ(encoders.measured().angle, truth.angle);
  EXPECT_EQ(encoders.measured().speed, truth.speed);
}

TEST(Encoders, RoundToTheNearestStep)
{
  Encoders encoders({0.01, 0.0, 0.005, 0.0}, kSeed);
  Random random(kSeed);
  for (int k = 0; k < 200; ++k)
  {
    const WheelMotion truth = any(random);
    encoders.measure(truth);
    for (std::size_t i = 0; i < kWheels; ++i)
    {
      const double angle = encoders.measured().angle[i], speed = encoders.measured().speed[i];
      ASSERT_LE(std::abs(angle - truth.angle[i]), 0.005 + 1e-12);
      ASSERT_NEAR(std::remainder(angle, 0.01), 0.0, 1e-12);
      ASSERT_LE(std::abs(speed - truth.speed[i]), 0.0025 + 1e-12);
      ASSERT_NEAR(std::remainder(speed, 0.005), 0.0, 1e-12);
    }
  }
}

TEST(Encoders, ScatterByTheDeviation)
{
  Encoders encoders({0.0, 0.002, 0.0, 0.03}, kSeed);
  double angle_sum = 0.0, angle_squares = 0.0, speed_squares = 0.0;
  constexpr int kSamples = 20000;
  for (int k = 0; k < kSamples; ++k)
  {
    encoders.measure({});
    angle_sum += encoders.measured().angle[1] / kSamples;
    angle_squares += std::pow(encoders.measured().angle[1], 2) / kSamples;
    speed_squares += std::pow(encoders.measured().speed[2], 2) / kSamples;
  }
  EXPECT_NEAR(angle_sum, 0.0, 5.0 * 0.002 / std::sqrt(kSamples));
  EXPECT_NEAR(std::sqrt(angle_squares), 0.002, 0.0001);
  EXPECT_NEAR(std::sqrt(speed_squares), 0.03, 0.0015);
}

TEST(Encoders, RepeatWithTheSameSeedOnly)
{
  const EncoderOptions noisy{0.0, 0.01, 0.0, 0.01};
  Encoders one(noisy, 7), same(noisy, 7), other(noisy, 8);
  for (Encoders* encoders : {&one, &same, &other}) encoders->measure({});
  EXPECT_EQ(one.measured().angle, same.measured().angle);
  EXPECT_EQ(one.measured().speed, same.measured().speed);
  EXPECT_NE(one.measured().angle, other.measured().angle);
}

TEST(Encoders, ThatFreezeKeepTheirReadingAndDoNotChangeTheOthers)
{
  const EncoderOptions noisy{0.0, 0.01, 0.0, 0.01};
  Encoders free(noisy, kSeed), frozen(noisy, kSeed);
  Random random(kSeed);
  const WheelMotion before = any(random);
  free.measure(before);
  frozen.measure(before);
  const WheelMotion kept = frozen.measured();
  frozen.freeze(2);
  for (int k = 0; k < 10; ++k)
  {
    const WheelMotion truth = any(random);
    free.measure(truth);
    frozen.measure(truth);
    for (std::size_t i : {0u, 1u, 3u}) ASSERT_EQ(frozen.measured().angle[i], free.measured().angle[i]);
    ASSERT_EQ(frozen.measured().angle[2], kept.angle[2]);
    ASSERT_EQ(frozen.measured().speed[2], kept.speed[2]);
  }
  frozen.release_all();
  free.measure(before);
  frozen.measure(before);
  EXPECT_EQ(frozen.measured().angle, free.measured().angle);
}

TEST(Encoders, RejectInvalidOptions)
{
  EXPECT_THROW(Encoders({-0.01, 0.0, 0.0, 0.0}, kSeed), std::invalid_argument);
  EXPECT_THROW(Encoders({0.0, 0.0, 0.0, NAN}, kSeed), std::invalid_argument);
}

}  // namespace
}  // namespace fourwis
