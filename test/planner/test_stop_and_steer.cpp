#include "planner/stop_and_steer.h"

#include <gtest/gtest.h>

#include "../support/drive.h"
#include "../support/grids.h"
#include "../support/path_laws.h"
#include "fourwis_navigation/referee/referee.h"
#include "fourwis_navigation/vehicle/wheels.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 13;
constexpr double kAccuracy = 1e-9;

/// Any chain of pieces, long and short, in all modes.
Path random_path(Random& random, const Robot& robot, int pieces)
{
  Path path;
  path.goal = {random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.angle()};
  Mode mode = random.mode();
  double phi = random.steering(robot, mode);
  for (int k = 0; k < pieces; ++k)
  {
    if (random.chance(0.4))
      mode = random.mode(), phi = random.steering(robot, mode);
    else if (random.chance(0.5))
      phi = random.chance(0.5) ? robot.max_steering_angle : -robot.max_steering_angle;
    const double length = random.chance(0.2) ? random.between(-0.01, 0.01) : random.between(-1.5, 1.5);
    path.pieces.push_back({mode, path.goal, phi, length});
    path.goal = advance(robot, path.goal, mode, phi, length);
  }
  return path;
}

struct StopAndSteer : testing::Test
{
  /// Visits trajectories along random paths of several robots.
  template <typename Visit>
  void for_trajectories(Visit visit) const
  {
    Random random(kSeed);
    for (int k = 0; k < 200; ++k)
    {
      Robot robot;
      if (k % 5 == 1) robot.wheel_max_rate = 1.0, robot.max_acceleration = 0.7;
      if (k % 5 == 2) robot.max_steering_rate = 0.5, robot.wheel_max_speed = 1.2;
      if (k % 5 == 3) robot.wheel_max_angle = 1.75;  // hardly more than a quarter turn
      if (k % 5 == 4) robot.wheel_max_angle = 1.6, robot.wheel_max_rate = 0.5;
      robot.max_speed = std::array<double, 4>{0.3, 0.8, 1.0, 2.0}[static_cast<std::size_t>(k) % 4];
      const Path path = random_path(random, robot, random.whole(1, 12));
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", path " + std::to_string(k) + " at " +
                   std::to_string(robot.max_speed) + " m/s\n" + text(path));
      visit(path, robot, stop_and_steer(path, robot));
      if (HasFatalFailure()) return;
    }
  }

  /// Visits each pair of neighbouring points.
  template <typename Visit>
  void for_steps(Visit visit) const
  {
    for_trajectories([&](const Path&, const Robot& robot, const Trajectory& trajectory) {
      for (std::size_t i = 1; i < trajectory.size(); ++i)
      {
        SCOPED_TRACE("point " + std::to_string(i) + " at t = " + std::to_string(trajectory[i].t));
        visit(robot, trajectory[i - 1], trajectory[i]);
        if (HasFatalFailure()) return;
      }
    });
  }
};

TEST_F(StopAndSteer, BeginsAtTheStartAndEndsAtTheGoalAtRest)
{
  for_trajectories([](const Path& path, const Robot&, const Trajectory& trajectory) {
    ASSERT_FALSE(trajectory.empty());
    const TrajectoryPoint &first = trajectory.front(), &last = trajectory.back();
    EXPECT_TRUE(is_bitwise_equal(first.pose(), path.pieces.front().start));
    EXPECT_EQ(first.t, 0.0);
    EXPECT_EQ(first.v, 0.0);
    EXPECT_LE(distance(last.pose(), path.goal), kAccuracy);
    EXPECT_NEAR(last.theta, path.goal.theta, kAccuracy);
    EXPECT_EQ(last.v, 0.0);
    EXPECT_EQ(last.a, 0.0);
    EXPECT_EQ(last.omega, 0.0);
  });
}

TEST_F(StopAndSteer, TakesTimeForEveryStep)
{
  for_steps([](const Robot&, const TrajectoryPoint& from, const TrajectoryPoint& to) { ASSERT_GT(to.t, from.t); });
}

TEST_F(StopAndSteer, KeepsTheLimitsOfSpeedAndAcceleration)
{
  for_steps([](const Robot& robot, const TrajectoryPoint& from, const TrajectoryPoint& to) {
    const double acceleration = (to.v - from.v) / (to.t - from.t);
    ASSERT_LE(std::abs(to.v), robot.max_speed + kAccuracy);
    ASSERT_LE(std::abs(to.v) * wheel_speed_ratio(robot, to.mode, to.phi), robot.wheel_max_speed + kAccuracy);
    ASSERT_LE(std::abs(acceleration), robot.max_acceleration * (1.0 + 1e-6));
    ASSERT_NEAR(from.a, acceleration, 1e-6);
  });
}

TEST_F(StopAndSteer, TurnsTheWheelsOnlyAtRestAndNoFasterThanTheyCan)
{
  constexpr int kSamples = 500;
  for_steps([](const Robot& robot, const TrajectoryPoint& from, const TrajectoryPoint& to) {
    if (from.mode != to.mode) return;
    const double dt = to.t - from.t, turn = to.phi - from.phi;
    ASSERT_LE(std::abs(turn) / dt, robot.max_steering_rate * (1.0 + 1e-6));
    ASSERT_NEAR(from.omega, turn / dt, 1e-9);
    if (turn == 0.0) return;
    ASSERT_EQ(from.v, 0.0);
    ASSERT_EQ(to.v, 0.0);
    ASSERT_GE(
        dt, reorientation_time(robot, wheel_angles(robot, from.mode, from.phi), wheel_angles(robot, to.mode, to.phi)) -
                kAccuracy);
    Robot unlimited = robot;
    unlimited.wheel_max_angle = 2.0 * M_PI;
    for (int k = 0; k < kSamples; ++k)
    {
      const double time = reorientation_time(unlimited, wheel_angles(robot, from.mode, from.phi + turn * k / kSamples),
                                             wheel_angles(robot, from.mode, from.phi + turn * (k + 1) / kSamples));
      ASSERT_LE(time, dt / kSamples * (1.0 + 1e-6));
    }
  });
}

TEST_F(StopAndSteer, SwitchesAtRestAndAsLongAsTheWheelsNeed)
{
  int switches = 0;
  for_steps([&](const Robot& robot, const TrajectoryPoint& from, const TrajectoryPoint& to) {
    if (from.mode == to.mode) return;
    ++switches;
    ASSERT_EQ(from.v, 0.0);
    ASSERT_EQ(to.v, 0.0);
    ASSERT_LE(distance(from.pose(), to.pose()), kAccuracy);
    ASSERT_NEAR(from.theta, to.theta, kAccuracy);
    ASSERT_GE(to.t - from.t, robot.mode_switch_time - kAccuracy);
    ASSERT_GE(to.t - from.t, reorientation_time(robot, wheel_angles(robot, from.mode, from.phi),
                                                wheel_angles(robot, to.mode, to.phi)) -
                                 kAccuracy);
  });
  EXPECT_GT(switches, 100);
}

TEST_F(StopAndSteer, MovesAsTheModeDoes)
{
  for_steps([](const Robot& robot, const TrajectoryPoint& from, const TrajectoryPoint& to) {
    const double length = (from.v + to.v) / 2.0 * (to.t - from.t);
    const Pose expected = drive_numerically(robot, from.pose(), to.mode, to.phi, length, 20);
    ASSERT_LE(distance(expected, to.pose()), 1e-7);
    ASSERT_NEAR(expected.theta, to.theta, 1e-7);
  });
}

TEST_F(StopAndSteer, PassesEveryPlaceWherePiecesMeet)
{
  for_trajectories([](const Path& path, const Robot& robot, const Trajectory& trajectory) {
    std::size_t i = 0;
    for (std::size_t k = 1; k < path.pieces.size(); ++k)
    {
      const PathPiece &piece = path.pieces[k], &before = path.pieces[k - 1];
      if (piece.mode == before.mode && piece.phi == before.phi && piece.length * before.length > 0.0) continue;
      const auto is_here = [&](const TrajectoryPoint& p) {
        return p.v == 0.0 && distance(p.pose(), piece.start) < 1e-7 && std::abs(p.theta - piece.start.theta) < 1e-7;
      };
      while (i < trajectory.size() && !is_here(trajectory[i])) ++i;
      ASSERT_LT(i, trajectory.size()) << "no stop at piece " << k << " for " << robot.length;
    }
  });
}

TEST_F(StopAndSteer, IsAcceptedByTheReferee)
{
  const OccupancyGrid grid = free_area(60.0, 60.0, 0.5, {-30.0, -30.0, 0.0});
  for_trajectories([&](const Path& path, const Robot& robot, const Trajectory& trajectory) {
    const Verdict verdict = Referee(grid, {}, robot).judge(path.pieces.front().start, path.goal, trajectory);
    ASSERT_TRUE(verdict.accepted()) << verdict.violations.front().point << ": " << verdict.violations.front().what;
  });
}

/// Time along a path of one or two pieces from the origin.
double arrival(const std::vector<PathPiece>& pieces, double speed = 1.0)
{
  Robot robot;
  robot.max_speed = speed;
  Path path;
  for (PathPiece piece : pieces)
  {
    piece.start = path.goal;
    path.goal = advance(robot, piece.start, piece.mode, piece.phi, piece.length);
    path.pieces.push_back(piece);
  }
  return stop_and_steer(path, robot).back().t;
}

TEST(StopAndSteerTime, IsThatOfATrapezoidOfSpeed)
{
  EXPECT_NEAR(arrival({{Mode::ackermann, {}, 0.0, 2.0}}), 2.0 + 0.2, kAccuracy);
  EXPECT_NEAR(arrival({{Mode::lateral, {}, 0.0, -2.0}}, 0.5), 4.0 + 0.1, kAccuracy);
}

TEST(StopAndSteerTime, IsThatOfATriangleOfSpeedOnAShortPiece)
{
  EXPECT_NEAR(arrival({{Mode::parallel, {}, 0.3, 0.1}}), 2.0 * std::sqrt(0.1 / 5.0), kAccuracy);
}

TEST(StopAndSteerTime, DoesNotDependOnHowAMotionIsCutIntoPieces)
{
  const PathPiece part = {Mode::ackermann, {}, 0.2, 0.7};
  PathPiece whole = part;
  whole.length *= 3.0;
  EXPECT_NEAR(arrival({part, part, part}), arrival({whole}), kAccuracy);
}

TEST(StopAndSteerTime, HasHalfASecondForAQuarterTurnOfAllWheels)
{
  const PathPiece forward = {Mode::ackermann, {}, 0.0, 1.0}, left = {Mode::lateral, {}, 0.0, 1.0};
  EXPECT_NEAR(arrival({forward, left}), arrival({forward}) + 0.5 + arrival({left}), kAccuracy);
}

TEST(StopAndSteerTime, HasAtLeastTheSwitchingTimeForASwitchThatTurnsNoWheel)
{
  const PathPiece forward = {Mode::ackermann, {}, 0.0, 1.0}, ahead = {Mode::parallel, {}, 0.0, 1.0};
  EXPECT_NEAR(arrival({forward, ahead}), arrival({forward}) + 0.4 + arrival({ahead}), kAccuracy);
}

TEST(StopAndSteerTime, IsNotSpentWhereThereIsNoPath)
{
  EXPECT_TRUE(stop_and_steer({}, {}).empty());
}

}  // namespace
}  // namespace fourwis
