#include "track/forecast.h"

#include <gtest/gtest.h>

#include "random_stretch.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 46;

TEST(Forecast, WhatIsAskedForHappensLater)
{
  TrackOptions options;
  Forecast forecast(Robot(), options);
  forecast.restart(Mode::ackermann, 0.1);
  EXPECT_EQ(forecast.asked(0.0).v, 0.0);
  EXPECT_EQ(forecast.asked(0.0).phi, 0.1);
  forecast.ask(1.0, {0.5, 0.2}, 0.1);
  EXPECT_EQ(forecast.asked(0.9).v, 0.0);
  EXPECT_NEAR(forecast.asked(1.05).v, 0.25, 1e-12);
  EXPECT_NEAR(forecast.asked(1.05).phi, 0.15, 1e-12);
  EXPECT_NEAR(forecast.asked(7.0).v, 0.5, 1e-12);
  forecast.ask(1.04, {0.2, 0.1}, 0.1);  // a new command before the last one has been carried out
  EXPECT_NEAR(forecast.asked(1.03).v, 0.15, 1e-12);
  EXPECT_NEAR(forecast.asked(1.04).v, 0.2, 1e-12);
  EXPECT_NEAR(forecast.asked(1.09).v, 0.2, 1e-12);
}

/// A robot that follows the commands is where the forecast says, for any age of the pose.
TEST(Forecast, FollowsACommandedMotion)
{
  const Robot robot;
  Random random(kSeed);
  for (int trial = 0; trial < 50; ++trial)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
    const Mode mode = random.mode();
    const Trajectory points = random_stretch(random, robot, mode, 0.02, 100);
    Forecast forecast(robot, {});
    forecast.restart(mode, points.front().phi);
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
      forecast.ask(points[k].t, {points[k + 1].v, points[k + 1].phi}, 0.02);
    const int from = random.whole(10, 60), to = from + random.whole(0, 30);
    const TrajectoryPoint &begin = points[static_cast<std::size_t>(from)], &end = points[static_cast<std::size_t>(to)];
    const MotionState state = forecast.ahead(begin.pose(), begin.t, end.t);
    EXPECT_LT(distance(state.pose, end.pose()), 1e-4);
    EXPECT_NEAR(state.pose.theta, end.theta, 1e-4);
    EXPECT_NEAR(state.v, end.v, 1e-9);
    EXPECT_NEAR(state.phi, end.phi, 1e-9);
  }
}

/// Wheels that are measured to be too slow approach the commanded speed with their lag.
TEST(Forecast, ADeviationFadesWithTheLag)
{
  TrackOptions options;
  options.drive_lag = 0.1;
  Forecast forecast(Robot(), options);
  forecast.restart(Mode::ackermann, 0.0);
  forecast.ask(0.0, {1.0, 0.0}, 0.0);
  forecast.measured(0.0, {0.6, 0.0});
  const double way = forecast.ahead({}, 0.0, 1.0).pose.x;
  EXPECT_NEAR(way, 1.0 - 0.4 * 0.1 * (1.0 - std::exp(-10.0)), 1e-3);
}

TEST(Forecast, ManyCommandsAndOldOnesDoNoHarm)
{
  Forecast forecast(Robot(), {});
  forecast.restart(Mode::parallel, 0.0);
  for (int k = 0; k < 5000; ++k) forecast.ask(0.02 * k, {0.5, 0.001 * k}, 0.02);
  EXPECT_NEAR(forecast.asked(99.99).phi, 4.9985, 1e-9);
  EXPECT_NO_THROW(forecast.asked(-5.0));
  forecast.ask(-100.0, {0.1, 0.2}, 0.02);
  EXPECT_NEAR(forecast.asked(0.0).v, 0.1, 1e-12);
}

}  // namespace
}  // namespace fourwis
