#include "fourwis_navigation/corridor/obstacle_rectangles.h"

#include <gtest/gtest.h>

#include "../support/grids.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 7;

struct RandomGrids : testing::Test
{
  /// Sizes around those of the tiles, from free to full.
  template <typename Visit>
  void for_grids(Visit visit)
  {
    const int sizes[] = {1, 2, 31, 32, 33, 64, 65, 90};
    const double densities[] = {0.0, 0.01, 0.1, 0.5, 0.95, 1.0};
    for (int k = 0; k < 200; ++k)
    {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", grid " + std::to_string(k));
      const OccupancyGrid grid = scattered(random, sizes[random.whole(0, 7)], sizes[random.whole(0, 7)], 0.1,
                                           random.pose(20.0), densities[k % 6]);
      visit(grid, ObstacleMap(grid));
      if (HasFailure()) return;
    }
  }

  static bool is_obstacle(const OccupancyGrid& grid, double x, double y)
  {
    const int column = static_cast<int>(std::floor(x / grid.resolution));
    const int row = static_cast<int>(std::floor(y / grid.resolution));
    if (column < 0 || row < 0 || column >= grid.width || row >= grid.height) return true;
    return ObstacleRule().is_obstacle(grid.at(column, row));
  }

  Random random{kSeed};
};

bool holds(const Box& box, double x, double y)
{
  return x >= box.x_min && x <= box.x_max && y >= box.y_min && y <= box.y_max;
}

double area(const Box& box)
{
  return (box.x_max - box.x_min) * (box.y_max - box.y_min);
}

TEST_F(RandomGrids, TheNextObstacleIsTheFirstOneAlongTheRow)
{
  for_grids([](const OccupancyGrid& grid, const ObstacleMap& map) {
    for (int row = 0; row < grid.height; ++row)
      for (int column = 0, next = 0; column <= grid.width; ++column)
      {
        for (next = column; next < grid.width && !ObstacleRule().is_obstacle(grid.at(next, row));) ++next;
        ASSERT_EQ(map.next_obstacle(column, row), next) << column << " " << row;
      }
  });
}

TEST(ObstacleMapRows, TheNextObstacleIsFoundHoweverFarItIs)
{
  OccupancyGrid grid = free_grid(150000, 1, 0.05);
  EXPECT_EQ(ObstacleMap(grid).next_obstacle(3, 0), grid.width);
  cell(grid, 140000, 0) = 100;
  EXPECT_EQ(ObstacleMap(grid).next_obstacle(3, 0), 140000);
}

TEST_F(RandomGrids, RectanglesAreTheObstaclesAndDoNotOverlap)
{
  for_grids([&](const OccupancyGrid& grid, const ObstacleMap& map) {
    const ObstacleRectangles obstacles(map);
    double covered = 0.0, occupied = 0.0;
    for (const Box& rectangle : obstacles.rectangles()) covered += area(rectangle);
    for (int row = 0; row < grid.height; ++row)
      for (int column = 0; column < grid.width; ++column)
      {
        const double x = (column + 0.5) * grid.resolution, y = (row + 0.5) * grid.resolution;
        const auto& all = obstacles.rectangles();
        const bool covers = std::any_of(all.begin(), all.end(), [&](const Box& box) { return holds(box, x, y); });
        ASSERT_EQ(covers, is_obstacle(grid, x, y)) << column << " " << row;
        occupied += covers ? grid.resolution * grid.resolution : 0.0;
      }
    EXPECT_NEAR(covered, occupied, 1e-9);
  });
}

TEST_F(RandomGrids, AWindowShowsExactlyWhatLiesInItAndTheOutside)
{
  for_grids([&](const OccupancyGrid& grid, const ObstacleMap& map) {
    const ObstacleRectangles obstacles(map);
    const double width = grid.width * grid.resolution, height = grid.height * grid.resolution;
    const double x = random.between(-1.0, width + 1.0), y = random.between(-1.0, height + 1.0);
    const Box window{x, y, x + random.between(0.0, width), y + random.between(0.0, height)};
    std::vector<Box> seen;
    obstacles.any_of(window, [&](const Box& box) {
      EXPECT_TRUE(box.x_min >= window.x_min && box.y_min >= window.y_min && box.x_max <= window.x_max &&
                  box.y_max <= window.y_max);
      seen.push_back(box);
      return false;
    });
    for (int k = 0; k < 200; ++k)
    {
      const double px = random.between(window.x_min, window.x_max), py = random.between(window.y_min, window.y_max);
      const bool shows = std::any_of(seen.begin(), seen.end(), [&](const Box& box) { return holds(box, px, py); });
      ASSERT_EQ(shows, is_obstacle(grid, px, py)) << px << " " << py;
    }
  });
}

TEST_F(RandomGrids, LookingEndsWithTheFirstObstacleThatWillDo)
{
  for_grids([](const OccupancyGrid&, const ObstacleMap& map) {
    int asked = 0;
    const bool found = ObstacleRectangles(map).any_of({-1.0, -1.0, 1.0, 1.0}, [&](const Box&) { return ++asked == 2; });
    EXPECT_TRUE(found);
    EXPECT_EQ(asked, 2);
  });
}

TEST_F(RandomGrids, PointsAndHalfPlanesChangeFramesTogether)
{
  for_grids([&](const OccupancyGrid& grid, const ObstacleMap& map) {
    const ObstacleRectangles obstacles(map);
    const Pose in_grid{random.between(-5.0, 5.0), random.between(-5.0, 5.0), 0.0};
    const Pose in_map = compose(grid.origin, in_grid);
    const Point2 point = obstacles.to_grid(in_map.x, in_map.y);
    EXPECT_NEAR(point.x, in_grid.x, 1e-9);
    EXPECT_NEAR(point.y, in_grid.y, 1e-9);
    const Point2 back = obstacles.to_map(point);
    EXPECT_NEAR(back.x, in_map.x, 1e-9);
    EXPECT_NEAR(back.y, in_map.y, 1e-9);
    const double angle = random.angle();
    const HalfPlane plane{std::cos(angle), std::sin(angle), random.between(-5.0, 5.0)};
    const HalfPlane turned = obstacles.to_map(plane);
    EXPECT_NEAR(turned.a * in_map.x + turned.b * in_map.y - turned.c, plane.a * point.x + plane.b * point.y - plane.c,
                1e-9);
  });
}

}  // namespace
}  // namespace fourwis
