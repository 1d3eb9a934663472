// Where a robot may start and where it may end: judged by its exact body.

#include <gtest/gtest.h>

#include "../support/driven_poses.h"
#include "../support/random.h"
#include "../support/rectangle.h"
#include "../support/sentences.h"
#include "fourwis_navigation/planner/planner.h"
#include "hall.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 91;

struct Start : testing::Test
{
  Start() { options.planner_patience = 60.0; }

  PlanResult plan(const OccupancyGrid& grid, const Pose& start, const Pose& goal, const ModeSet& modes = {}) const
  {
    return Planner(options).plan(World(grid, robot, options), {start, goal, modes});
  }

  /// A pose beside the lower wall, so far from it; negative: in it.
  Pose beside_wall(double gap, double x = 1.0) const { return {x, 1.0 + robot.width / 2.0 + gap, 0.0}; }

  /// Seen by rectangles alone: the body overlaps no more than at the start, never more than before, and not again once it was
  /// free.
  void expect_way_out(const OccupancyGrid& grid, const Trajectory& trajectory, double start_depth) const
  {
    const ExactRectangle body(grid, robot);
    double least = start_depth + 1e-6;
    for (const Pose& pose : driven_poses(robot, trajectory))
    {
      if (!body.collides(pose))
      {
        least = 0.0;
        continue;
      }
      const double depth = body.depth(pose);
      ASSERT_LE(depth, least + 1e-6) << text(pose);
      least = std::min(least, depth);
    }
    EXPECT_EQ(least, 0.0) << "it is never free";
  }

  Robot robot;
  PlannerOptions options;
  const OccupancyGrid hall = slot_hall();
  const Pose there = {4.5, 2.5, 0.0};
};

TEST_F(Start, AMillimetreFromAWallIsLeft)
{
  for (double gap : {0.013, 0.005, 0.001, 0.0002})
  {
    const PlanResult result = plan(hall, beside_wall(gap), there);
    ASSERT_EQ(result.status, PlanStatus::succeeded) << gap << ": " << result.message;
    EXPECT_EQ(result.overlap, 0.0) << gap;
    expect_way_out(hall, result.trajectory, 0.0);
  }
}

TEST_F(Start, AMillimetreFromAWallIsReached)
{
  for (double gap : {0.013, 0.005, 0.001})
  {
    const PlanResult result = plan(hall, there, beside_wall(gap));
    ASSERT_EQ(result.status, PlanStatus::succeeded) << gap << ": " << result.message;
    expect_way_out(hall, result.trajectory, 0.0);
  }
}

TEST_F(Start, FromWallToWall)
{
  const PlanResult result = plan(hall, beside_wall(0.001, 1.0), beside_wall(0.004, 5.0));
  ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
  expect_way_out(hall, result.trajectory, 0.0);
}

TEST_F(Start, WithoutASafetyMarginAHairFromAWallIsLeft)
{
  robot.safety_margin = 0.0;
  for (double gap : {0.001, 0.0002})
  {
    const PlanResult result = plan(hall, beside_wall(gap), there);
    ASSERT_EQ(result.status, PlanStatus::succeeded) << gap << ": " << result.message;
    expect_way_out(hall, result.trajectory, 0.0);
  }
}

TEST_F(Start, SlightlyInAWallIsLeftWithoutGoingDeeper)
{
  for (double depth : {0.001, 0.02, 0.029})
    for (double turn : {0.0, -1.2})
    {
      Pose start = beside_wall(0.0);
      start.theta = turn;
      start.y = 1.0 + robot.width / 2.0 * std::cos(turn) + robot.length / 2.0 * std::abs(std::sin(turn)) - depth;
      const double overlap = ExactRectangle(hall, robot).depth(start);
      const PlanResult result = plan(hall, start, there);
      ASSERT_EQ(result.status, PlanStatus::succeeded) << depth << " at " << turn << ": " << result.message;
      EXPECT_NEAR(result.overlap, overlap, 1e-5) << depth << " at " << turn;
      EXPECT_TRUE(says(result.message, "overlaps an obstacle by 0.0")) << depth;
      expect_way_out(hall, result.trajectory, overlap);
    }
}

TEST_F(Start, SlightlyInAWallIsLeftAlsoToAGoalThatIsVeryNear)
{
  const PlanResult result = plan(hall, beside_wall(-0.01), beside_wall(0.001));
  ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
  expect_way_out(hall, result.trajectory, 0.01);
}

TEST_F(Start, RandomOverlapsAreLeftWithoutGoingDeeperOrRefusedByTheirDepth)
{
  const ExactRectangle body(hall, robot);
  Random random(kSeed);
  int left = 0, refused = 0;
  while (left + refused < 15)
  {
    const Pose start = {random.between(0.4, 5.6), random.between(0.9, 1.7), random.angle()};
    const double depth = body.depth(start);
    if (depth < 0.001 || depth > 0.05 || std::abs(depth - 0.03) < 1e-4) continue;
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", " + text(start));
    const PlanResult result = plan(hall, start, there);
    if (depth > 0.03)
    {
      EXPECT_EQ(result.status, PlanStatus::start_in_collision) << result.message;
      ++refused;
      continue;
    }
    ASSERT_EQ(result.status, PlanStatus::succeeded) << depth << ": " << result.message;
    expect_way_out(hall, result.trajectory, depth);
    ++left;
  }
  EXPECT_GT(left, 4);
}

TEST_F(Start, DeeperInAWallIsRefusedWithItsDepth)
{
  const PlanResult result = plan(hall, beside_wall(-0.04), there);
  EXPECT_EQ(result.status, PlanStatus::start_in_collision);
  EXPECT_TRUE(says(result.message, "overlaps an obstacle by 0.040 m"));
  EXPECT_TRUE(result.trajectory.empty());
  options.referee.start_tolerance = 0.05;
  EXPECT_EQ(plan(hall, beside_wall(-0.04), there).status, PlanStatus::succeeded);
  options.referee.start_tolerance = 0.0;
  EXPECT_EQ(plan(hall, beside_wall(-0.001), there).status, PlanStatus::start_in_collision);
}

TEST_F(Start, AGoalInAWallIsRefusedByAMillimetre)
{
  const PlanResult result = plan(hall, there, beside_wall(-0.001));
  EXPECT_EQ(result.status, PlanStatus::goal_in_collision);
  EXPECT_TRUE(says(result.message, "overlaps an obstacle by 0.001 m"));
}

/// A SLAM's first map has seen nothing of the ground that the robot stands on.
TEST_F(Start, OnUnseenCellsIsOnFreeGround)
{
  OccupancyGrid grid = free_area(6.0, 4.0, 0.05);
  for (int row = 34; row < 46; ++row)
    for (int column = 12; column < 28; ++column) cell(grid, column, row) = -1;
  for (const Pose& start : {Pose{1.0, 2.0, 0.0}, Pose{1.0, 2.0, 0.4}})
  {
    const PlanResult result = plan(grid, start, there);
    ASSERT_EQ(result.status, PlanStatus::succeeded) << result.message;
    EXPECT_EQ(result.overlap, 0.0);
  }
}

TEST_F(Start, UnseenCellsAreNeitherAGoalNorDrivenOver)
{
  OccupancyGrid grid = free_area(6.0, 4.0, 0.05);
  for (int row = 34; row < 46; ++row)
    for (int column = 12; column < 28; ++column) cell(grid, column, row) = -1;
  const PlanResult there_is_none = plan(grid, there, {1.0, 2.0, 0.0});
  EXPECT_EQ(there_is_none.status, PlanStatus::goal_in_collision);
  EXPECT_TRUE(says(there_is_none.message, "lies on cells that no sensor has seen"));
  const PlanResult round = plan(grid, {1.0, 3.0, 0.0}, {1.0, 1.0, 0.0});
  ASSERT_EQ(round.status, PlanStatus::succeeded) << round.message;
  expect_way_out(grid, round.trajectory, 0.0);
}

TEST_F(Start, OnUnseenCellsIsNoLeaveToStandInAWall)
{
  OccupancyGrid grid = hall;
  for (int row = 60; row < 80; ++row)
    for (int column = 25; column < 75; ++column) cell(grid, column, row) = -1;
  EXPECT_EQ(plan(grid, beside_wall(0.005), there).status, PlanStatus::succeeded);
  EXPECT_EQ(plan(grid, beside_wall(-0.2), there).status, PlanStatus::start_in_collision);
}

/// Nothing is driven over that no sensor has seen but what the robot stands on.
TEST_F(Start, UnseenCellsElsewhereAreObstacles)
{
  OccupancyGrid grid = free_area(6.0, 4.0, 0.05);
  for (int row = 0; row < 80; ++row) cell(grid, 60, row) = -1;
  EXPECT_EQ(plan(grid, {1.0, 2.0, 0.0}, there).status, PlanStatus::goal_unreachable);
}

}  // namespace
}  // namespace fourwis
