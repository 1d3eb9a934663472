#include "fourwis_navigation/map/obstacle_map.h"

#include <gtest/gtest.h>

#include <limits>

#include "../support/grids.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 4;

/// Distance to the nearest obstacle of all, one after the other.
double brute_force_distance(const OccupancyGrid& grid, const ObstacleRule& rule, double x, double y)
{
  const Pose point = relative_to(grid.origin, {x, y, 0.0});
  const double u = point.x / grid.resolution, v = point.y / grid.resolution;
  double best = std::max(0.0, std::min({u, v, grid.width - u, grid.height - v}));
  for (int j = 0; j < grid.height; ++j)
    for (int i = 0; i < grid.width; ++i)
      if (rule.is_obstacle(grid.at(i, j)))
        best = std::min(best, std::hypot(std::max({i - u, u - i - 1.0, 0.0}), std::max({j - v, v - j - 1.0, 0.0})));
  return best * grid.resolution;
}

/// The gap between the square of a cell and the nearest obstacle.
double brute_force_cell_distance(const OccupancyGrid& grid, int column, int row)
{
  const int border = std::min({column, row, grid.width - 1 - column, grid.height - 1 - row});
  double best = border;
  for (int j = 0; j < grid.height; ++j)
    for (int i = 0; i < grid.width; ++i)
      if (ObstacleRule().is_obstacle(grid.at(i, j)))
        best = std::min(best, std::hypot(std::max(0, std::abs(i - column) - 1), std::max(0, std::abs(j - row) - 1)));
  return best * grid.resolution;
}

/// Grids of every size, density and place, each with points in and around it, many of them on edges and corners.
struct RandomGrids : testing::Test
{
  template <typename Visit>
  void for_grids(Visit visit)
  {
    const double densities[] = {0.0, 0.01, 0.05, 0.3, 0.8, 1.0}, resolutions[] = {0.03, 0.05, 0.07, 0.1, 0.15};
    for (int k = 0; k < 120; ++k)
    {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", grid " + std::to_string(k));
      const Pose origin = k % 3 == 0 ? Pose{} : random.pose(20.0);
      const OccupancyGrid grid =
          scattered(random, random.whole(1, 40), random.whole(1, 40), resolutions[k % 5], origin, densities[k % 6]);
      visit(grid, ObstacleMap(grid));
      if (HasFatalFailure()) return;
    }
  }

  template <typename Visit>
  void for_points(Visit visit)
  {
    for_grids([&](const OccupancyGrid& grid, const ObstacleMap& map) {
      for (int k = 0; k < 60; ++k)
      {
        double u = random.between(-2.0, grid.width + 2.0), v = random.between(-2.0, grid.height + 2.0);
        if (k % 3 == 0) u = std::round(u);
        if (k % 6 == 0) v = std::round(v);
        const Pose point = compose(grid.origin, {u * grid.resolution, v * grid.resolution, 0.0});
        visit(grid, map, point.x, point.y);
        if (HasFatalFailure()) return;
      }
    });
  }

  Random random{kSeed};
};

TEST_F(RandomGrids, TheDistanceIsThatToTheNearestOfAllSquares)
{
  for_points([](const OccupancyGrid& grid, const ObstacleMap& map, double x, double y) {
    ASSERT_NEAR(map.distance(x, y), brute_force_distance(grid, {}, x, y), 1e-9) << text(Pose{x, y, 0.0});
  });
}

TEST_F(RandomGrids, APointIsClearWhenItsDistanceIsAtLeastTheRadius)
{
  for_points([this](const OccupancyGrid& grid, const ObstacleMap& map, double x, double y) {
    const double distance = map.distance(x, y), span = grid.resolution * 8.0;
    for (double radius : {distance * (1.0 - 1e-9) - 1e-9, distance * (1.0 + 1e-9) + 1e-9, random.between(0.0, span),
                          random.between(0.0, span), 1e-9, -1e-9, -1.0})
    {
      double clearance = 1e9;
      ASSERT_EQ(map.is_clear(x, y, radius), distance >= radius) << text(Pose{x, y, 0.0}) << " r " << radius;
      ASSERT_EQ(map.is_clear(x, y, radius, clearance), distance >= radius) << text(Pose{x, y, 0.0}) << " r " << radius;
    }
  });
}

TEST_F(RandomGrids, EveryPointIsClearOfNoRadiusAtAll)
{
  for_points([](const OccupancyGrid&, const ObstacleMap& map, double x, double y) {
    ASSERT_TRUE(map.is_clear(x, y, 0.0)) << text(Pose{x, y, 0.0});
  });
}

TEST_F(RandomGrids, TheClearanceIsALowerBoundAndNeverNegativeAndNeverRises)
{
  int lowered = 0;
  for_points([&](const OccupancyGrid& grid, const ObstacleMap& map, double x, double y) {
    const double distance = map.distance(x, y), radius = random.between(0.0, distance);
    const double before = random.between(0.0, 6.0 * grid.resolution);
    double clearance = before;
    ASSERT_TRUE(map.is_clear(x, y, radius, clearance)) << text(Pose{x, y, 0.0}) << " r " << radius;
    ASSERT_GE(clearance, 0.0);
    ASSERT_LE(clearance, before);
    ASSERT_LE(clearance, distance - radius + 1e-9) << text(Pose{x, y, 0.0}) << " r " << radius;
    lowered += clearance < before;
  });
  EXPECT_GT(lowered, 1000);
}

TEST_F(RandomGrids, TheDistanceOfACellIsTheGapBetweenSquaresRoundedDown)
{
  for_grids([&](const OccupancyGrid& grid, const ObstacleMap& map) {
    for (int k = 0; k < 30; ++k)
    {
      const int column = random.whole(0, grid.width - 1), row = random.whole(0, grid.height - 1);
      const double gap = brute_force_cell_distance(grid, column, row);
      ASSERT_LE(map.cell_distance(column, row), gap) << column << ", " << row;
      ASSERT_GE(map.cell_distance(column, row), gap * (1.0 - 1e-5)) << column << ", " << row;
    }
  });
}

TEST_F(RandomGrids, NoPointOfACellIsCloserThanTheCell)
{
  for_grids([&](const OccupancyGrid& grid, const ObstacleMap& map) {
    for (int k = 0; k < 60; ++k)
    {
      const double u = random.between(0.0, grid.width), v = random.between(0.0, grid.height);
      const Pose point = compose(grid.origin, {u * grid.resolution, v * grid.resolution, 0.0});
      ASSERT_GE(map.distance(point.x, point.y), map.cell_distance(static_cast<int>(u), static_cast<int>(v)) - 1e-12);
    }
  });
}

TEST_F(RandomGrids, PositionsInCellsAreCountedFromTheOriginAlongTheGridsAxes)
{
  for_points([](const OccupancyGrid& grid, const ObstacleMap& map, double x, double y) {
    const Pose in_grid = relative_to(grid.origin, {x, y, 0.0});
    double column, row;
    map.to_cells(x, y, column, row);
    ASSERT_NEAR(column * grid.resolution, in_grid.x, 1e-9);
    ASSERT_NEAR(row * grid.resolution, in_grid.y, 1e-9);
  });
}

TEST(ObstacleMap, IsOfTheGridsSizeAndPlace)
{
  const ObstacleMap map(free_grid(7, 4, 0.1, {1.0, -2.0, 0.5}));
  EXPECT_EQ(map.width(), 7);
  EXPECT_EQ(map.height(), 4);
  EXPECT_EQ(map.resolution(), 0.1);
  EXPECT_EQ(map.origin().x, 1.0);
  EXPECT_EQ(map.origin().y, -2.0);
  EXPECT_EQ(map.origin().theta, 0.5);
}

TEST(ObstacleMap, OfOneFreeCellIsBoundedByItsBorder)
{
  const ObstacleMap map(free_grid(1, 1, 0.2));
  EXPECT_NEAR(map.distance(0.1, 0.1), 0.1, 1e-12);
  EXPECT_NEAR(map.distance(0.15, 0.1), 0.05, 1e-12);
  EXPECT_EQ(map.distance(0.3, 0.1), 0.0);
}

TEST(ObstacleMap, FullOfObstaclesIsNowhereClear)
{
  OccupancyGrid grid = free_grid(20, 10, 0.05);
  occupy_block(grid, 0, 0, 20, 10);
  const ObstacleMap map(grid);
  for (double x = -0.2; x < 1.2; x += 0.05)
  {
    EXPECT_EQ(map.distance(x, 0.25), 0.0);
    EXPECT_FALSE(map.is_clear(x, 0.25, 1e-9));
  }
}

TEST(ObstacleMap, TreatsNothingAsClearThatIsNotANumber)
{
  const ObstacleMap map(free_grid(20, 20, 0.1));
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (double bad : {nan, infinity, -infinity, 1e300})
  {
    EXPECT_EQ(map.distance(bad, 1.0), 0.0);
    EXPECT_EQ(map.distance(1.0, bad), 0.0);
    EXPECT_FALSE(map.is_clear(bad, 1.0, 0.1));
    EXPECT_FALSE(map.is_clear(1.0, bad, 0.1));
  }
}

TEST(ObstacleRule, TakesUnknownCellsForObstaclesUnlessToldOtherwise)
{
  ObstacleRule unknown_is_free;
  unknown_is_free.unknown_is_obstacle = false;
  for (int value : {-1, -128, -100, 101, 127})
  {
    OccupancyGrid grid = free_grid(9, 9, 0.1);
    cell(grid, 4, 4) = static_cast<std::int8_t>(value);
    EXPECT_EQ(ObstacleMap(grid).distance(0.45, 0.45), 0.0) << value;
    EXPECT_NEAR(ObstacleMap(grid, unknown_is_free).distance(0.45, 0.45), 0.45, 1e-9) << value;
  }
}

TEST(ObstacleRule, TakesCellsFromTheThresholdOnForObstacles)
{
  ObstacleRule rule;
  rule.occupied_threshold = 40;
  for (int value : {0, 1, 39, 40, 41, 64, 65, 100})
  {
    OccupancyGrid grid = free_grid(9, 9, 0.1);
    cell(grid, 4, 4) = static_cast<std::int8_t>(value);
    EXPECT_EQ(ObstacleMap(grid).distance(0.45, 0.45) == 0.0, value >= 65) << value;
    EXPECT_EQ(ObstacleMap(grid, rule).distance(0.45, 0.45) == 0.0, value >= 40) << value;
  }
}

TEST(ObstacleRule, OutOfRangeIsRejectd)
{
  ObstacleRule rule;
  for (const int bad : {0, 101})
  {
    rule.occupied_threshold = bad;
    EXPECT_THROW(ObstacleMap(free_grid(9, 9, 0.1), rule), std::invalid_argument);
  }
}

}  // namespace
}  // namespace fourwis
