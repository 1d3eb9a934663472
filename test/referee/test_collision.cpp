// The collision check and the clearance of the referee against brute force: separating axes and distances of all edges,
// for every cell of the grid.

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>

#include "../support/driven_poses.h"
#include "../support/grids.h"
#include "../support/random.h"
#include "brute_clearance.h"
#include "referee_script.h"

namespace fourwis
{
namespace
{

/// Cells occupied or unknown with the given probability.
OccupancyGrid random_grid(Random& random, double resolution, double probability, int cells)
{
  const int height = cells + random.whole(-10, 10);
  Pose origin = {random.between(-9.0, 9.0), random.between(-9.0, 9.0), 0.0};
  if (random.chance(0.75)) origin.theta = random.between(-4.0, 4.0);
  OccupancyGrid grid = free_grid(cells, height, resolution, origin);
  for (auto& value : grid.data)
    if (random.chance(probability)) value = random.chance(0.5) ? 100 : -1;
  return grid;
}

/// A pose in the map frame on the grid, sometimes a little beyond it.
Pose random_pose(Random& random, const OccupancyGrid& grid)
{
  const double w = grid.width * grid.resolution, h = grid.height * grid.resolution;
  const double theta = random.chance(0.8) ? random.between(-7.0, 7.0) : random.whole(-4, 4) * M_PI_4;
  const double turn = random.chance(0.5) ? theta : theta - grid.origin.theta;
  return compose(grid.origin, {random.between(-0.02, 1.02) * w, random.between(-0.02, 1.02) * h, turn});
}

/// A referee that tolerates no overlap at the start.
Referee strict(const OccupancyGrid& grid, const ObstacleRule& rule, const Robot& robot)
{
  RefereeOptions options;
  options.start_tolerance = 0.0;
  return Referee(grid, rule, robot, options);
}

Verdict stand(const Referee& referee, const Pose& pose)
{
  return referee.judge(pose, pose, Script(pose, Mode::ackermann).points());
}

TEST(VerifyCollision, OfStandingBodiesAgreesWithBruteForceOnRandomGrids)
{
  int free = 0, colliding = 0;
  for (unsigned seed = 1; seed <= 60; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double resolution = std::array<double, 5>{0.02, 0.05, 0.1, 0.31, 1.0}[seed % 5];
    const double share = random.between(0.0, 0.3) * resolution;
    const int cells_per_side = random.whole(60, 140);
    const OccupancyGrid grid = random_grid(random, resolution, share, cells_per_side);
    Robot robot;
    if (seed % 3 == 0) robot.length = random.between(0.1, 1.5), robot.width = random.between(0.1, 1.5);
    robot.wheelbase = std::min(robot.wheelbase, robot.length);
    robot.track_width = std::min(robot.track_width, robot.width);
    const ObstacleRule rule{65, seed % 2 == 0};
    const Referee referee = strict(grid, rule, robot);
    const std::vector<Quad> cells = obstacles(grid, rule);
    for (int k = 0; k < 20; ++k)
    {
      const Pose pose = random_pose(random, grid);
      const double expected = brute_clearance(grid, cells, pose, robot);
      if (std::abs(expected) < 1e-7) continue;
      const Verdict verdict = stand(referee, pose);
      ASSERT_EQ(verdict.accepted(), expected > 0.0) << "clearance " << expected << "\n" << sentences(verdict);
      ASSERT_EQ(complains_of(verdict, "collision"), expected < 0.0);
      ASSERT_NEAR(verdict.min_clearance, std::max(0.0, expected), 1e-9);
      ++(expected > 0.0 ? free : colliding);
    }
  }
  EXPECT_GT(free, 200);
  EXPECT_GT(colliding, 200);
}

TEST(VerifyCollision, SeesASingleCellWhereverItIsUnderTheBody)
{
  Random random(7);
  const Pose pose{2.0, 2.0, 0.7};
  int inside = 0;
  for (int k = 0; k < 400; ++k)
  {
    OccupancyGrid grid = free_grid(90, 90, 0.05, {random.between(-0.1, 0.1), random.between(-0.1, 0.1), 0.0});
    const int column = random.whole(25, 55), row = random.whole(25, 55);
    occupy(grid, column, row);
    const double expected = separation(body(pose), square_of(grid, column, row));
    const Verdict verdict = stand(strict(grid, {}, {}), pose);
    EXPECT_EQ(verdict.accepted(), expected >= 0.0) << column << ' ' << row << ' ' << expected;
    if (expected >= 0.0) continue;
    ++inside;
    EXPECT_TRUE(complains_of(verdict, "column " + std::to_string(column) + ", row " + std::to_string(row)));
  }
  EXPECT_GT(inside, 50);
}

TEST(VerifyCollision, TouchingIsFree)
{
  // Body 1.0 x 0.6 at (2, 2): its edges lie on cell borders, and cells touch it on all sides and at its corners.
  Robot robot;
  robot.width = 0.6;
  OccupancyGrid grid = free_grid(40, 40, 0.1);
  for (int column = 14; column <= 25; ++column) occupy(grid, column, 16), occupy(grid, column, 23);
  for (int row = 16; row <= 23; ++row) occupy(grid, 14, row), occupy(grid, 25, row);
  const Referee referee = strict(grid, {}, robot);
  const Verdict touching = stand(referee, {2.0, 2.0, 0.0});
  EXPECT_TRUE(touching.accepted()) << sentences(touching);
  EXPECT_NEAR(touching.min_clearance, 0.0, 1e-12);
  EXPECT_TRUE(stand(referee, {2.0, 2.0, M_PI}).accepted());
  for (const Pose& deeper : {Pose{2.00001, 2.0, 0.0}, Pose{1.99999, 2.0, 0.0}, Pose{2.0, 2.00001, 0.0},
                             Pose{2.0, 1.99999, 0.0}, Pose{2.0, 2.0, 0.0001}, Pose{2.0, 2.0, M_PI_2}})
    EXPECT_FALSE(stand(referee, deeper).accepted()) << deeper.x << ' ' << deeper.y << ' ' << deeper.theta;
}

TEST(VerifyCollision, TheBorderOfTheGridMayBeTouchedButNotCrossed)
{
  const Pose origin{3.0, -2.0, 0.5};
  const OccupancyGrid grid = free_grid(50, 40, 0.1, origin);  // 5 m x 4 m
  const Referee referee = strict(grid, {}, {});
  for (const auto& [x, y] : {std::pair(0.5, 2.0), {4.5, 2.0}, {2.0, 0.31}, {2.0, 3.69}})
  {
    const Verdict verdict = stand(referee, compose(origin, {x, y, 0.0}));
    EXPECT_TRUE(verdict.accepted()) << sentences(verdict);
    EXPECT_NEAR(verdict.min_clearance, 0.0, 1e-9);
  }
  for (const auto& [x, y] : {std::pair(0.49999, 2.0), {4.50001, 2.0}, {2.0, 0.30999}, {2.0, 3.69001}, {-50.0, 2.0}})
    EXPECT_TRUE(complains_of(stand(referee, compose(origin, {x, y, 0.0})), "leaves the grid")) << x << ' ' << y;
}

TEST(VerifyCollision, CellsAreObstaclesByTheRule)
{
  const auto collides = [](std::int8_t value, const ObstacleRule& rule) {
    OccupancyGrid grid = free_grid(60, 60, 0.05);
    occupy(grid, 30, 30, value);
    return !stand(strict(grid, rule, {}), {1.5, 1.5, 0.0}).accepted();
  };
  EXPECT_FALSE(collides(64, {65, true}));
  EXPECT_TRUE(collides(65, {65, true}));
  EXPECT_TRUE(collides(-1, {65, true}));
  EXPECT_FALSE(collides(-1, {65, false}));
  EXPECT_TRUE(collides(101, {65, true}));
}

TEST(VerifyCollision, SeesAPostBetweenTwoPointsFarApart)
{
  OccupancyGrid grid = free_grid(300, 80, 0.05);
  const Script script = Script({1.0, 2.0, 0.0}, Mode::ackermann).drive(1.0, 10.0);
  EXPECT_TRUE(strict(grid, {}, {}).judge(script.start(), script.end(), script.points()).accepted());
  occupy(grid, 150, 40);
  const Verdict verdict = strict(grid, {}, {}).judge(script.start(), script.end(), script.points());
  ASSERT_EQ(verdict.violations.size(), 1u) << sentences(verdict);
  EXPECT_EQ(verdict.violations[0].point, 1);
  EXPECT_NEAR(verdict.violations[0].t, (7.5 - 0.5 - 1.125) + 0.25, 0.02);  // the front edge reaches x = 7.5 m
}

TEST(VerifyCollision, SeesThatACellIsGrazedByMicrometres)
{
  // The left edge of the body runs along y = 2.31, the cell's lower edge along y = 2.31 + gap.
  for (const double speed : {0.3, 0.7, 1.0})
    for (const double gap : {-1e-5, 1e-5})
    {
      OccupancyGrid grid = free_grid(300, 80, 0.05, {0.0, 0.01 + gap, 0.0});
      occupy(grid, 150, 46);
      const Script script = Script({1.0, 2.0, 0.0}, Mode::ackermann).drive(speed, 10.0 / speed);
      const Verdict verdict = strict(grid, {}, {}).judge(script.start(), script.end(), script.points());
      EXPECT_EQ(verdict.accepted(), gap > 0.0) << sentences(verdict);
      EXPECT_NEAR(verdict.min_clearance, std::max(gap, 0.0), 1e-9);
    }
}

TEST(VerifyCollision, SeesACornerNickedForLittleMoreThanAMillimetre)
{
  // The front left corner of the body moves down to the right past the lower left corner of a cell, at (3, 3).
  OccupancyGrid grid = free_grid(120, 120, 0.05);
  occupy(grid, 60, 60);
  const Referee referee = strict(grid, {}, {});
  for (const double depth : {0.00065, -0.0005})
    for (int k = 0; k < 60; ++k)
    {
      SCOPED_TRACE("depth " + std::to_string(depth) + ", phase " + std::to_string(k));
      const double before = 0.7 + 0.0003 * k, beside = depth * M_SQRT1_2;
      const Pose start{3.0 + beside - before - 0.5, 3.0 + beside + before - 0.31, 0.0};
      const Script script = Script(start, Mode::parallel, -M_PI_4).drive(0.7, 2.5);
      const Verdict verdict = referee.judge(script.start(), script.end(), script.points());
      ASSERT_EQ(verdict.accepted(), depth < 0.0) << sentences(verdict);
      ASSERT_NEAR(verdict.min_clearance, depth < 0.0 ? 0.0008 : 0.0, 0.0004);
    }
}

TEST(VerifyCollision, ClearanceIsExactAtStartAndGoal)
{
  for (const double heading : {0.0, M_PI})  // towards the wall, away from it
    for (const double gap : {0.003, 0.0437, 0.291})
    {
      OccupancyGrid grid = free_grid(120, 80, 0.05);
      for (int row = 0; row < 80; ++row) occupy(grid, 100, row);
      const Script there = Script({}, Mode::ackermann).drive(0.7, 2.0);
      const double x = 5.0 - 0.5 - gap - (heading == 0.0 ? there.end().x : 0.0);
      const Script script = Script({x, 2.0, heading}, Mode::ackermann).drive(0.7, 2.0);
      EXPECT_NEAR(strict(grid, {}, {}).judge(script.start(), script.end(), script.points()).min_clearance, gap, 1e-9);
    }
}

/// A random drive in one or two modes with phi changing in motion. It does not keep the limits.
Script random_drive(Random& random, const Pose& start)
{
  Script script(start, random.mode(), random.between(-0.5, 0.5));
  for (int k = random.whole(1, 2); k > 0; --k)
  {
    script.go(0.5, random.between(-1.0, 1.0), random.between(-0.5, 0.5))
        .go(1.0, random.between(-1.0, 1.0), random.between(-0.5, 0.5));
    script.go(0.5, 0.0, random.between(-0.5, 0.5));
    if (k > 1) script.switch_to(random.mode(), 0.0, 1.0);
  }
  return script;
}

TEST(VerifyCollision, AlongMotionsAgreesWithBruteForceOnRandomGrids)
{
  int free = 0, colliding = 0;
  for (unsigned seed = 1; seed <= 120; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    OccupancyGrid grid =
        free_grid(70, 70, 0.1, {random.between(-4.0, 4.0), random.between(-4.0, 4.0), random.between(-3.0, 3.0)});
    for (int k = random.whole(0, 20); k > 0; --k) occupy(grid, random.whole(0, 69), random.whole(0, 69));
    const Script script = random_drive(random, compose(grid.origin, {3.5, 3.5, random.between(-3.0, 3.0)}));
    double expected = INFINITY;
    const std::vector<Quad> cells = obstacles(grid, {});
    for (const Pose& pose : driven_poses({}, script.points()))
      expected = std::min(expected, brute_clearance(grid, cells, pose));
    if (std::abs(expected) < 0.001) continue;
    const Verdict verdict = strict(grid, {}, {}).judge(script.start(), script.end(), script.points());
    ASSERT_EQ(complains_of(verdict, "collision"), expected < 0.0) << expected << "\n" << sentences(verdict);
    ASSERT_LT(verdict.max_rollout_position, 1e-5);
    ++(expected > 0.0 ? free : colliding);
    if (expected < 0.0)
      ASSERT_EQ(verdict.min_clearance, 0.0);
    else
    {
      ASSERT_GT(verdict.min_clearance, expected - 0.001);
      ASSERT_LT(verdict.min_clearance, std::max(expected * 8.0 / 7.0, expected + 0.005) + 1e-6);
    }
  }
  EXPECT_GT(free, 40);
  EXPECT_GT(colliding, 20);
}

/// The corners of a long body that turns move several times as far as its centre. The post is met by the leading corner
/// only; at the end it lies just in front of the body.
TEST(VerifyCollision, SeesAPostThatOnlyATurningCornerMeets)
{
  // A long body that goes sideways, and the same turned by a right angle: a wide one that goes ahead.
  for (const bool wide : {false, true})
  {
    SCOPED_TRACE(wide ? "wide" : "long");
    Robot robot;
    robot.length = 2.4;
    if (wide)
    {
      std::swap(robot.length, robot.width);
      std::swap(robot.wheelbase, robot.track_width);
    }
    const Mode mode = wide ? Mode::ackermann : Mode::lateral;
    const Pose start = wide ? Pose{3.002, 3.0, 0.0} : Pose{3.0, 3.002, 0.0};
    const double phi = 0.5, radius = 0.52 / (2.0 * std::tan(phi)), ahead = radius + 2.4 / 2;
    const Pose centre = wide ? Pose{start.x, start.y + radius, 0.0} : Pose{start.x - radius, start.y, 0.0};
    const double from_centre = wide ? -M_PI_2 : 0.0;  // the direction of C at the start
    int met = 0;
    for (int k = 0; k < 60; ++k)
    {
      SCOPED_TRACE(k);
      const Script script = Script(start, mode, phi, robot).drive(0.8, 0.5 + 0.01 * k);
      OccupancyGrid grid = free_grid(600, 600, 0.01);
      // Beside the body at the start: the least clearance is there.
      if (wide)
        occupy(grid, 268, 209);
      else
        occupy(grid, 390, 268);
      // Between the circle that the edge touches and that of the corners.
      const double angle = from_centre + script.end().theta + 0.05, reach = ahead + 0.02;
      occupy(grid, static_cast<int>((centre.x + reach * std::cos(angle)) / 0.01),
             static_cast<int>((centre.y + reach * std::sin(angle)) / 0.01));
      const std::vector<Quad> cells = obstacles(grid, {});
      double expected = INFINITY;
      for (const Pose& pose : driven_poses(robot, script.points()))
        expected = std::min(expected, brute_clearance(grid, cells, pose, robot));
      if (std::abs(expected) < 0.001) continue;
      const Verdict verdict = strict(grid, {}, robot).judge(script.start(), script.end(), script.points());
      EXPECT_EQ(complains_of(verdict, "collision"), expected < 0.0) << expected;
      met += expected < 0.0;
    }
    EXPECT_GT(met, 50);
  }
}

/// A rolled-out motion may miss the next point a little. The way to that point is checked as well.
TEST(VerifyCollision, SeesWhatIsMetWithinTheTolerancesOfTheRollOut)
{
  OccupancyGrid grid = free_grid(80, 80, 0.05);
  occupy(grid, 44, 50);  // 0.55 m from the middle, within the circle of the corners
  const Pose turn{0.0, 0.0, 0.009}, shift{0.004, 0.0, 0.0};
  for (const auto& [start, step] : {std::pair(Pose{2.0, 2.0, 0.0}, turn), {Pose{0.8, 2.3, 0.0}, shift}})
  {
    Trajectory points;
    for (int k = 0; k < 250; ++k)
    {
      TrajectoryPoint point;
      point.t = 0.1 * k;
      point.mode = Mode::ackermann;
      point.x = start.x + k * step.x, point.y = start.y + k * step.y, point.theta = start.theta + k * step.theta;
      points.push_back(point);
    }
    const Verdict verdict = strict(grid, {}, {}).judge(points.front().pose(), points.back().pose(), points);
    EXPECT_FALSE(complains_of(verdict, "rolled-out")) << sentences(verdict);
    EXPECT_TRUE(complains_of(verdict, "collision")) << sentences(verdict);
  }
}

TEST(VerifyCollision, OneRefereeJudgesInSeveralThreads)
{
  Random random(3);
  OccupancyGrid grid = free_grid(140, 140, 0.05);
  for (int k = 0; k < 20; ++k) occupy(grid, random.whole(0, 139), random.whole(0, 139));
  const Referee referee = strict(grid, {}, {});
  const Script script = random_drive(random, {3.5, 3.5, 1.0});
  const Verdict expected = referee.judge(script.start(), script.end(), script.points());
  std::array<Verdict, 4> verdicts;
  std::vector<std::thread> threads;
  for (Verdict& verdict : verdicts)
    threads.emplace_back([&] {
      for (int k = 0; k < 50; ++k) verdict = referee.judge(script.start(), script.end(), script.points());
    });
  for (std::thread& thread : threads) thread.join();
  for (const Verdict& verdict : verdicts)
  {
    EXPECT_EQ(sentences(verdict), sentences(expected));
    EXPECT_EQ(verdict.min_clearance, expected.min_clearance);
  }
}

}  // namespace
}  // namespace fourwis
