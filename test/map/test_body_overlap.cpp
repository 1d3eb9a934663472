#include "fourwis_navigation/map/body_overlap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "../support/exact_polygon.h"
#include "../support/grids.h"
#include "../support/rectangle.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 71;
/// Overlaps of less than this are a touch [m].
constexpr double kTouch = 1e-6;

Robot larger(Robot robot, double by)
{
  robot.length += 2.0 * by;
  robot.width += 2.0 * by;
  return robot;
}

Robot any_robot(Random& random)
{
  Robot robot;
  robot.length = random.between(0.1, 1.6);
  robot.width = random.between(0.1, 1.6);
  return robot;
}

/// Calls visit(grid, map, random) for cluttered maps of several resolutions, turned any way.
template <typename Visit>
void for_maps(Visit visit)
{
  Random random(kSeed);
  for (double resolution : {0.02, 0.05, 0.1, 0.3})
    for (int k = 0; k < 5; ++k)
    {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", resolution " + std::to_string(resolution) + ", map " +
                   std::to_string(k));
      const OccupancyGrid grid = clutter(random, 5.0, resolution, 8, random.pose(10.0));
      visit(grid, ObstacleMap(grid), random);
      if (testing::Test::HasFatalFailure()) return;
    }
}

/// On the grid, or a little beyond it; sometimes in line with its axes.
Pose any_pose(const OccupancyGrid& grid, Random& random)
{
  const double turn = random.chance(0.3) ? random.whole(-4, 4) * M_PI_4 : random.angle();
  return compose(grid.origin, {random.between(-0.3, 5.3), random.between(-0.3, 5.3), turn});
}

/// The polygon at a pose, in the frame of the grid.
std::vector<Point2> placed_polygon(const OccupancyGrid& grid, const ConvexPolygon& body, const Pose& pose)
{
  std::vector<Point2> corners;
  for (const Point2& corner : body)
  {
    const Pose at = relative_to(grid.origin, compose(pose, {corner.x, corner.y, 0.0}));
    corners.push_back({at.x, at.y});
  }
  return corners;
}

std::vector<Point2> square(const OccupancyGrid& grid, int column, int row)
{
  const double r = grid.resolution, x = column * r, y = row * r;
  return {{x, y}, {x + r, y}, {x + r, y + r}, {x, y + r}};
}

ConvexPolygon any_polygon(Random& random)
{
  const double x = random.between(-0.6, 0.6), y = random.between(-0.3, 0.3), a = random.between(0.1, 0.8),
               b = random.between(0.1, 0.8);
  const double first = random.angle();
  ConvexPolygon polygon;
  const int corners = random.whole(3, 7);
  for (int k = 0; k < corners; ++k)
  {
    const double angle = first + 2.0 * M_PI * (k + random.between(0.0, 0.5)) / corners;
    polygon.push_back({x + a * std::cos(angle), y + b * std::sin(angle)});
  }
  return polygon;
}

TEST(IsClear, AgreesWithTheExactRectangle)
{
  int clear = 0, blocked = 0;
  for_maps([&](const OccupancyGrid& grid, const ObstacleMap& map, Random& random) {
    for (int k = 0; k < 300; ++k)
    {
      const Robot robot = any_robot(random);
      const Pose pose = any_pose(grid, random);
      const bool is_free = is_clear(map, body_of(robot), placed(pose));
      ASSERT_TRUE(is_free || ExactRectangle(grid, larger(robot, kTouch)).collides(pose)) << text(pose);
      ASSERT_TRUE(!is_free || !ExactRectangle(grid, larger(robot, -kTouch)).collides(pose)) << text(pose);
      ++(is_free ? clear : blocked);
    }
  });
  EXPECT_GT(clear, 300);
  EXPECT_GT(blocked, 300);
}

TEST(IsClear, AgreesWithSeparatingAxesForPolygonsAnywhereAboutC)
{
  int clear = 0, blocked = 0;
  for_maps([&](const OccupancyGrid& grid, const ObstacleMap& map, Random& random) {
    const double side = grid.width * grid.resolution;
    for (int k = 0; k < 200; ++k)
    {
      const ConvexPolygon body = any_polygon(random);
      const Pose pose = any_pose(grid, random);
      const std::vector<Point2> corners = placed_polygon(grid, body, pose);
      bool collides = false, is_inside = true;
      for (const Point2& c : corners) is_inside &= std::min(c.x, c.y) >= 0.0 && std::max(c.x, c.y) <= side;
      for (int row = 0; row < grid.height; ++row)
        for (int column = 0; column < grid.width; ++column)
          if (grid.at(column, row) > 0 && overlap_depth(corners, square(grid, column, row)) > kTouch) collides = true;
      ASSERT_EQ(is_clear(map, body, placed(pose)), is_inside && !collides) << text(pose);
      ++(is_inside && !collides ? clear : blocked);
    }
  });
  EXPECT_GT(clear, 300);
  EXPECT_GT(blocked, 300);
}

TEST(OverlappedCells, AreThoseThatNoSideSeparates)
{
  for_maps([](const OccupancyGrid& grid, const ObstacleMap& map, Random& random) {
    for (int k = 0; k < 60; ++k)
    {
      const ConvexPolygon body = any_polygon(random);
      const Pose pose = any_pose(grid, random);
      std::set<std::pair<int, int>> found;
      for (const CellIndex& cell : overlapped_cells(map, body, pose))
        ASSERT_TRUE(found.insert({cell.column, cell.row}).second);
      const std::vector<Point2> corners = placed_polygon(grid, body, pose);
      for (int row = 0; row < grid.height; ++row)
        for (int column = 0; column < grid.width; ++column)
        {
          const bool is_found = found.count({column, row}) > 0;
          ASSERT_TRUE(is_found || !(overlap_depth(corners, square(grid, column, row)) > kTouch))
              << column << ' ' << row;
          ASSERT_TRUE(!is_found || overlap_depth(corners, square(grid, column, row)) > 0.0) << column << ' ' << row;
        }
    }
  });
}

TEST(LiesIn, IsAboutTheBorderAlone)
{
  OccupancyGrid grid = free_area(4.0, 3.0, 0.1, {5.0, -2.0, 0.7});
  occupy_block(grid, 0, 0, 40, 30);
  const ObstacleMap map(grid);
  const ConvexPolygon body = body_of({});
  for (const auto& [x, y, inside] :
       {std::tuple(2.0, 1.5, true), {0.5, 1.5, true}, {0.4999, 1.5, false}, {2.0, 2.69, true}, {2.0, 2.6901, false}})
    EXPECT_EQ(lies_in(map, body, compose(grid.origin, {x, y, 0.0})), inside) << x << ' ' << y;
  EXPECT_FALSE(lies_in(map, body, {std::nan(""), 0.0, 0.0}));
}

TEST(BodyClearance, IsByHowMuchTheSidesCanBeMovedOutward)
{
  int bounded = 0;
  for_maps([&](const OccupancyGrid& grid, const ObstacleMap& map, Random& random) {
    const Robot robot;
    for (int k = 0; k < 300; ++k)
    {
      const Pose pose = any_pose(grid, random);
      const double most = random.between(0.0, 0.2), clearance = body_clearance(map, body_of(robot), pose, most);
      ASSERT_LE(clearance, most);
      if (clearance < 0.0) continue;
      ASSERT_FALSE(ExactRectangle(grid, larger(robot, clearance - kTouch)).collides(pose)) << text(pose);
      if (clearance == most) continue;
      ++bounded;
      ASSERT_TRUE(ExactRectangle(grid, larger(robot, clearance + 3.0 * kTouch)).collides(pose)) << text(pose);
    }
  });
  EXPECT_GT(bounded, 100);
}

TEST(BodyClearance, IsTheDepthWhereTheBodyOverlaps)
{
  int deep = 0, hopeless = 0;
  for_maps([&](const OccupancyGrid& grid, const ObstacleMap& map, Random& random) {
    const Robot robot;
    const ExactRectangle rectangle(grid, robot);
    for (int k = 0; k < 300; ++k)
    {
      const Pose pose = any_pose(grid, random);
      const double depth = rectangle.depth(pose), clearance = body_clearance(map, body_of(robot), pose, 0.1);
      if (depth < kTouch || std::abs(depth - robot.width / 2.0) < 1e-5) continue;
      if (depth > robot.width / 2.0)
      {
        ASSERT_EQ(clearance, -std::numeric_limits<double>::infinity()) << text(pose);
        ++hopeless;
        continue;
      }
      ASSERT_NEAR(-clearance, depth, 3.0 * kTouch) << text(pose);
      ++deep;
    }
  });
  EXPECT_GT(deep, 100);
  EXPECT_GT(hopeless, 100);
}

TEST(BodyClearance, OfATouchIsNothing)
{
  OccupancyGrid grid = free_area(6.0, 4.0, 0.05);
  occupy_block(grid, 0, 0, 120, 20);
  const ObstacleMap map(grid);
  const Pose touching = {3.0, 1.0 + Robot().width / 2.0, 0.0};
  EXPECT_NEAR(body_clearance(map, body_of({}), touching, 0.1), 0.0, kTouch);
  EXPECT_GE(body_clearance(map, body_of({}), touching, 0.1), 0.0);
}

TEST(IsClear, IsFalseForNumbersThatAreNone)
{
  const ObstacleMap map(free_area(4.0, 4.0, 0.1));
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const Pose& pose :
       {Pose{nan, 2.0, 0.0}, {2.0, nan, 0.0}, {2.0, 2.0, nan}, {infinity, 2.0, 0.0}, {2.0, -1e300, 0.0}})
    EXPECT_FALSE(is_clear(map, body_of({}), placed(pose))) << text(pose);
}

}  // namespace
}  // namespace fourwis
