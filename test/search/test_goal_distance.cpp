#include "search/goal_distance.h"

#include <gtest/gtest.h>

#include <set>

#include "../support/grids.h"
#include "../support/path_laws.h"
#include "fourwis_navigation/search/hybrid_astar.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 9;
constexpr double kSlack = 4.0;
constexpr double kFar = 1000.0;  ///< a slack that covers every map here [m]

GoalDistance distances(const Site& site, const Pose& start, const Pose& goal, double slack = kFar)
{
  return GoalDistance({site.checker, start, goal}, slack);
}

TEST(CoarseCells, CoverTheMap)
{
  for (double resolution : {0.03, 0.05, 0.07, 0.3})
  {
    const Site site(free_grid(37, 22, resolution, {1.0, -2.0, 0.4}));
    const CoarseCells cells(site.map, 0.1);
    EXPECT_GE(cells.width() * cells.size(), 37 * resolution - 1e-6);
    EXPECT_GE(cells.height() * cells.size(), 22 * resolution - 1e-6);
    EXPECT_EQ(cells.count(), static_cast<std::size_t>(cells.width() * cells.height()));
  }
}

TEST(CoarseCells, AreFoundByEveryPointInThem)
{
  const Site site(free_grid(50, 31, 0.07, {1.0, -2.0, 0.4}));
  const CoarseCells cells(site.map, 0.1);
  Random random(kSeed);
  for (int index = 0; index < static_cast<int>(cells.count()); ++index)
  {
    const Pose centre = cells.centre(index);
    const Pose offset = {random.between(-0.0499, 0.0499), random.between(-0.0499, 0.0499), 0.0};
    const Pose point = compose({centre.x, centre.y, 0.4}, offset);
    ASSERT_EQ(cells.index(point.x, point.y), index);
  }
}

TEST(CoarseCells, OutsideTheMapAreTheNearestOnes)
{
  const Site site(free_grid(50, 30, 0.1));
  const CoarseCells cells(site.map, 0.1);
  EXPECT_EQ(cells.index(-1.0, -1.0), cells.index(0.01, 0.01));
  EXPECT_EQ(cells.index(9.0, 1.55), cells.index(4.99, 1.55));
  EXPECT_EQ(cells.index(2.0, 3.0), cells.index(2.0, 2.99));
}

TEST(CoarseCells, HaveUpToEightNeighboursEachOneCellAway)
{
  const Site site(free_grid(5, 4, 0.1));
  const CoarseCells cells(site.map, 0.1);
  for (int index = 0; index < 20; ++index)
  {
    const int column = index % 5, row = index / 5;
    std::set<int> seen;
    cells.for_neighbours(index, [&](int neighbour, bool diagonal) {
      seen.insert(neighbour);
      EXPECT_NEAR(distance(cells.centre(index), cells.centre(neighbour)), diagonal ? 0.1 * M_SQRT2 : 0.1, 1e-9);
    });
    const std::size_t across = column == 0 || column == 4 ? 2 : 3, along = row == 0 || row == 3 ? 2 : 3;
    EXPECT_EQ(seen.size(), across * along - 1);
  }
}

TEST(GoalDistance, IsNearlyTheStraightLineInTheOpenAndNeverMore)
{
  const Site site(free_area(12.0, 9.0, 0.05, {3.0, 2.0, 0.7}));
  Random random(kSeed);
  const Pose goal = free_pose(random, site.checker);
  const GoalDistance field = distances(site, free_pose(random, site.checker), goal);
  for (int k = 0; k < 2000; ++k)
  {
    const Pose pose = free_pose(random, site.checker);
    const double straight = distance(pose, goal);
    ASSERT_LE(field(pose.x, pose.y), straight) << text(pose);
    ASSERT_GE(field(pose.x, pose.y), 0.9 * straight - 0.4) << text(pose);
  }
}

TEST(GoalDistance, IsNothingAtTheGoal)
{
  const Site site(free_area(6.0, 6.0, 0.05));
  EXPECT_EQ(distances(site, {2.0, 2.0, 0.0}, {4.0, 3.0, 0.0})(4.0, 3.0), 0.0);
}

/// A wall from the lower border up to y = 7 of 10 m, between start and goal.
struct Detour : testing::Test
{
  Detour() { occupy_block(grid, 99, 0, 2, 140); }
  OccupancyGrid grid = free_area(10.0, 10.0, 0.05);
  const Pose start = {2.0, 2.0, 0.0}, goal = {8.0, 2.0, 0.0};
};

TEST_F(Detour, IsMeasuredAroundTheWall)
{
  const Site site(grid);
  const GoalDistance field = distances(site, start, goal);
  // Around the upper corners of the wall, which C, the centre of the wheels, passes at the robot's least clearance or
  // further away.
  const double around_a_point = 2.0 * std::hypot(2.95, 5.0) + 0.1;
  EXPECT_TRUE(field.reaches_start());
  EXPECT_GT(field(start.x, start.y), 0.9 * around_a_point);
  EXPECT_LT(field(start.x, start.y), around_a_point + 2.0 * 0.35);
}

TEST_F(Detour, IsKnownForAtLeastTheSlackBeyondTheStart)
{
  const Site site(grid);
  const GoalDistance near = distances(site, start, goal, kSlack), all = distances(site, start, goal);
  const double known = all(start.x, start.y) + 0.9 * kSlack;
  Random random(kSeed);
  for (int k = 0; k < 1000; ++k)
  {
    const Pose pose = free_pose(random, site.checker);
    const double full = all(pose.x, pose.y), partial = near(pose.x, pose.y);
    ASSERT_LE(partial, full + 1e-6) << text(pose);
    ASSERT_GE(partial, std::min(full, known) - 1e-6) << text(pose);
  }
}

TEST(GoalDistance, IsInfiniteBehindClosedWallsOfOneCell)
{
  for (double resolution : {0.02, 0.05, 0.1})
  {
    OccupancyGrid grid = free_area(8.0, 6.0, resolution);
    const int cells_per_metre = static_cast<int>(std::lround(1.0 / resolution));
    wall_in(grid, 5 * cells_per_metre, 2 * cells_per_metre, 2 * cells_per_metre, 2 * cells_per_metre);
    const Site site(grid);
    const GoalDistance from_inside = distances(site, {6.0, 3.0, 0.0}, {2.0, 3.0, 0.0});
    EXPECT_FALSE(from_inside.reaches_start()) << resolution;
    EXPECT_TRUE(std::isinf(from_inside(6.0, 3.0))) << resolution;
    const GoalDistance from_outside = distances(site, {2.0, 3.0, 0.0}, {6.0, 3.0, 0.0});
    EXPECT_FALSE(from_outside.reaches_start()) << resolution;
    EXPECT_TRUE(std::isinf(from_outside(2.0, 3.0))) << resolution;
  }
}

TEST(GoalDistance, IsInfiniteBehindADoorTooNarrowForTheRobotsWidth)
{
  OccupancyGrid grid = free_area(8.0, 6.0, 0.05);
  occupy_block(grid, 80, 0, 1, 120);
  for (int row = 56; row < 66; ++row) cell(grid, 80, row) = 0;  // a door of 0.5 m
  const Site site(grid);
  EXPECT_FALSE(distances(site, {2.0, 3.0, 0.0}, {6.0, 3.0, 0.0}).reaches_start());
}

TEST(GoalDistance, IsNoLongerThanAnyPathFound)
{
  Random random(kSeed);
  int found = 0;
  for (int k = 0; k < 40; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", problem " + std::to_string(k));
    const Site site(clutter(random, 8.0, k % 2 ? 0.05 : 0.07, 16, random.pose(5.0)));
    const PlanRequest request = {free_pose(random, site.checker), free_pose(random, site.checker), {}};
    const GoalDistance field = distances(site, request.start, request.goal, kSlack);
    SearchOptions options;
    options.max_expansions = 1000;
    const auto straight = [&](const Pose& pose) { return distance(pose, request.goal); };
    const Path path =
        hybrid_astar({site.checker, request.start, request.goal}, options, request.modes, {straight}).path;
    if (path.pieces.empty()) continue;
    ++found;
    ASSERT_TRUE(field.reaches_start());
    double left = path.length();
    for (const PathPiece& piece : path.pieces)
    {
      ASSERT_LE(field(piece.start.x, piece.start.y), left + 1e-6) << "at " << text(piece.start) << "\n" << text(path);
      left -= std::abs(piece.length);
    }
  }
  EXPECT_GT(found, 15);
}

TEST(GoalDistance, StopsWhenInterrupted)
{
  const std::atomic<bool> cancelled{true};
  const Site site(free_area(40.0, 40.0, 0.1));
  const GoalDistance field({site.checker, {1.0, 1.0, 0.0}, {39.0, 39.0, 0.0}, Interrupt(&cancelled)}, kFar);
  EXPECT_FALSE(field.reaches_start());
}

}  // namespace
}  // namespace fourwis
