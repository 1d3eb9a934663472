#include "search/holonomic_distance.h"

#include <gtest/gtest.h>

#include "../support/grids.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 10;
constexpr double kSpacing = 0.025;        ///< of the lattice [m]
constexpr double kCell = 2.0 * kSpacing;  ///< [m]
constexpr double kSlack = 4.0;            ///< [m]

TEST(HolonomicDistance, IsNothingAtTheGoalAndAboutTheStraightLineInTheOpen)
{
  const Site site(free_area(8.0, 8.0, 0.05));
  const Pose goal = {4.0, 4.0, 0.5};
  const HolonomicDistance field({site.checker, {1.0, 1.0, 0.5}, goal}, kSpacing, kSlack);
  EXPECT_EQ(field(goal), 0.0);
  EXPECT_TRUE(field.reaches_start());
  Random random(kSeed);
  for (int k = 0; k < 1000; ++k)
  {
    const Pose pose = {random.between(0.8, 7.2), random.between(0.8, 7.2), goal.theta};
    ASSERT_NEAR(field(pose), distance(pose, goal), 0.15 * distance(pose, goal) + 0.2) << text(pose);
  }
}

TEST(HolonomicDistance, ChargesForTurningTheShorterWayRound)
{
  const Site site(free_area(6.0, 6.0, 0.05));
  const Pose goal = {3.0, 3.0, 0.0};
  const HolonomicDistance field({site.checker, {1.5, 1.5, 0.0}, goal}, kSpacing, kSlack);
  EXPECT_GT(field({3.0, 3.0, M_PI_4}), 0.0);
  EXPECT_GT(field({3.0, 3.0, M_PI_2}), field({3.0, 3.0, M_PI_4}));
  EXPECT_GT(field({3.0, 3.0, M_PI}), field({3.0, 3.0, M_PI_2}));
  for (double turn : {0.5, M_PI_2, 2.5}) EXPECT_NEAR(field({3.0, 3.0, turn}), field({3.0, 3.0, -turn}), 3.0 * kCell);
}

/// A hall that a wall divides, with a gap of 0.7 m in the middle: wide enough for a body of 0.62 m that goes straight.
OccupancyGrid divided_hall()
{
  OccupancyGrid grid = free_area(8.0, 6.0, 0.05);
  occupy_block(grid, 78, 0, 4, 120);
  for (int row = 53; row < 67; ++row)
    for (int column = 78; column < 82; ++column) cell(grid, column, row) = 0;
  return grid;
}

TEST(HolonomicDistance, LeadsThroughAGapAtTheHeadingsAtWhichTheBodyFits)
{
  const Site site(divided_hall());
  const CollisionChecker body(site.map, site.robot, std::vector<Pose>());
  const Pose start = {2.0, 4.0, M_PI_2}, goal = {6.0, 3.0, 0.0};
  const HolonomicDistance field({body, start, goal}, kSpacing, kSlack);
  EXPECT_TRUE(field.reaches_start());
  EXPECT_LT(field({4.0, 3.0, 0.0}), 2.5);
  EXPECT_GT(field({4.0, 3.0, M_PI_2}), 4.0) << "no body fits across the gap";
  // A quarter turn of 16 headings, three cells' worth each, and more than four metres.
  EXPECT_NEAR(field(start), 4.2 + 3 * 16 * kCell, 0.5);
}

TEST(HolonomicDistance, ShowsTheWayAheadCellByCell)
{
  const Site site(divided_hall());
  const CollisionChecker body(site.map, site.robot, std::vector<Pose>());
  const Pose start = {2.0, 4.0, 0.0}, goal = {6.0, 3.0, 0.0};
  const HolonomicDistance field({body, start, goal}, kSpacing, kSlack);
  std::vector<Pose> way;
  field.way_ahead(start, way);
  ASSERT_GT(way.size(), 50u);
  Pose before = start;
  for (const Pose& pose : way)
  {
    EXPECT_LE(distance(before, pose), kCell * 2.2);
    EXPECT_LE(field(pose), field(before)) << "its points may lie on the border to the cell before";
    EXPECT_EQ(pose.theta, start.theta);
    EXPECT_TRUE(body.is_free(pose)) << text(pose);
    before = pose;
  }
  EXPECT_LT(distance(way.back(), goal), 0.15);
  field.way_ahead({4.0, 3.0, M_PI_2}, way);
  EXPECT_TRUE(way.empty()) << "it has to turn first";
}

TEST(HolonomicDistance, StopsWhenInterrupted)
{
  const std::atomic<bool> cancelled{true};
  const Site site(divided_hall());
  const SearchProblem problem = {site.checker, {2.0, 4.0, 0.0}, {6.0, 3.0, 0.0}, Interrupt(&cancelled)};
  EXPECT_EQ(HolonomicDistance(problem, kSpacing, kSlack)({2.0, 4.0, 0.0}), kCell) << "not a step further";
}

}  // namespace
}  // namespace fourwis
