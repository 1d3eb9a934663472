#include "fourwis_navigation/referee/metrics.h"

#include <gtest/gtest.h>

#include "../support/random.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "planner/stop_and_steer.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 14;

PlanMetrics measured(const Trajectory& trajectory)
{
  PlanMetrics metrics;
  measure(trajectory, {}, metrics);
  return metrics;
}

/// The trajectory of a path from the origin.
Trajectory driven(const std::vector<PathPiece>& pieces)
{
  Path path;
  for (PathPiece piece : pieces)
  {
    piece.start = path.goal;
    path.goal = advance({}, piece.start, piece.mode, piece.phi, piece.length);
    path.pieces.push_back(piece);
  }
  return stop_and_steer(path, {});
}

TEST(Metrics, OfNoTrajectoryAreNothing)
{
  const PlanMetrics metrics = measured({});
  EXPECT_EQ(metrics.length, 0.0);
  EXPECT_EQ(metrics.arrival_time, 0.0);
  EXPECT_EQ(metrics.mean_curvature, 0.0);
  EXPECT_EQ(metrics.max_curvature, 0.0);
  EXPECT_EQ(metrics.switches, 0);
}

TEST(Metrics, OfOnePointAreThoseOfStandingStill)
{
  TrajectoryPoint point;
  point.mode = Mode::ackermann;
  const PlanMetrics metrics = measured({point});
  EXPECT_EQ(metrics.length, 0.0);
  EXPECT_EQ(metrics.arrival_time, 0.0);
  EXPECT_EQ(metrics.standard_mode_rate, 1.0);
}

TEST(Metrics, OfAStraightLineAreItsLengthAndTime)
{
  const PlanMetrics metrics = measured(driven({{Mode::ackermann, {}, 0.0, 2.0}}));
  EXPECT_NEAR(metrics.length, 2.0, 1e-9);
  EXPECT_NEAR(metrics.arrival_time, 2.2, 1e-9);
  EXPECT_NEAR(metrics.mean_curvature, 0.0, 1e-6);
  EXPECT_NEAR(metrics.max_curvature, 0.0, 1e-6);
  EXPECT_EQ(metrics.standard_mode_rate, 1.0);
}

TEST(Metrics, OfAnArcAreItsCurvature)
{
  for (Mode mode : {Mode::ackermann, Mode::lateral})
    for (double phi : {0.1, -0.3, M_PI / 6.0})
    {
      const double kappa = std::abs(curvature({}, mode, phi));
      const PlanMetrics metrics = measured(driven({{mode, {}, phi, 1.5}}));
      EXPECT_NEAR(metrics.mean_curvature, kappa, 1e-6) << to_string(mode) << phi;
      EXPECT_NEAR(metrics.max_curvature, kappa, 1e-6) << to_string(mode) << phi;
      EXPECT_LT(metrics.length, 1.5);
      EXPECT_GT(metrics.length, 1.49);
    }
}

TEST(Metrics, HaveNoCurvatureAtSwitchesAndReversals)
{
  const PlanMetrics metrics = measured(driven({{Mode::ackermann, {}, 0.0, 1.0},
                                               {Mode::lateral, {}, 0.0, 1.0},
                                               {Mode::lateral, {}, 0.0, -0.5},
                                               {Mode::parallel, {}, 0.7, 1.0}}));
  EXPECT_NEAR(metrics.max_curvature, 0.0, 1e-6);
  EXPECT_EQ(metrics.switches, 2);
}

TEST(Metrics, AverageOverTheCurvaturesOfAllPieces)
{
  const double kappa = curvature({}, Mode::ackermann, 0.3);
  const PlanMetrics metrics = measured(driven({{Mode::ackermann, {}, 0.0, 1.0}, {Mode::ackermann, {}, 0.3, 1.0}}));
  EXPECT_NEAR(metrics.max_curvature, kappa, 1e-6);
  EXPECT_NEAR(metrics.mean_curvature, kappa / 2.0, 0.05 * kappa);
}

TEST(Metrics, CallMotionInTheModesStandard)
{
  Random random(kSeed);
  for (int k = 0; k < 50; ++k)
  {
    std::vector<PathPiece> pieces;
    for (int i = 0; i < 5; ++i)
    {
      const Mode mode = random.mode();
      pieces.push_back({mode, {}, random.steering({}, mode), random.between(-1.0, 1.0)});
    }
    EXPECT_EQ(measured(driven(pieces)).standard_mode_rate, 1.0);
  }
}

TEST(Metrics, DoNotCallTurningWhileSlidingDiagonallyStandard)
{
  Trajectory trajectory(11);
  for (std::size_t i = 0; i < trajectory.size(); ++i)
  {
    const double t = 0.1 * static_cast<double>(i);
    trajectory[i].t = t;
    trajectory[i].theta = 2.0 * t;
    // Of C, the centre of the wheels: half a metre per second forward and half a metre per second to the left.
    const double middle = 2.0 * (t - 0.05);
    if (i == 0) continue;
    trajectory[i].x = trajectory[i - 1].x + 0.05 * (std::cos(middle) - std::sin(middle));
    trajectory[i].y = trajectory[i - 1].y + 0.05 * (std::sin(middle) + std::cos(middle));
  }
  EXPECT_EQ(measured(trajectory).standard_mode_rate, 0.0);
}

TEST(Metrics, DoNotDependOnWhereTheTrajectoryLies)
{
  const std::vector<PathPiece> pieces = {{Mode::ackermann, {}, 0.3, 1.0}, {Mode::parallel, {}, 0.7, -1.0}};
  Trajectory moved = driven(pieces);
  for (TrajectoryPoint& point : moved)
  {
    const Pose pose = compose({3.0, -5.0, 2.0}, point.pose());
    point.x = pose.x, point.y = pose.y, point.theta = pose.theta;
  }
  const PlanMetrics here = measured(driven(pieces)), there = measured(moved);
  EXPECT_NEAR(here.length, there.length, 1e-9);
  EXPECT_NEAR(here.mean_curvature, there.mean_curvature, 1e-6);
  EXPECT_NEAR(here.max_curvature, there.max_curvature, 1e-6);
  EXPECT_EQ(here.standard_mode_rate, there.standard_mode_rate);
}

}  // namespace
}  // namespace fourwis
