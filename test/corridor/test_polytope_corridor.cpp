#include "fourwis_navigation/corridor/polytope_corridor.h"

#include <limits>
#include <stdexcept>

#include "polytope_laws.h"

namespace fourwis
{
namespace
{

TEST(PolytopeCorridor, NextToAWallTheRegionReachesTheWallAndTheRange)
{
  const ObstacleRectangles obstacles{ObstacleMap(above_a_wall())};
  PolytopeOptions options;
  options.range = 1.5;
  const PolytopeCorridor corridor = polytope_corridor(obstacles, kDiscs, options, {{5.0, 2.0, 0.0}, {5.2, 2.0, 0.0}});
  ASSERT_EQ(corridor.status, CorridorStatus::succeeded);
  const double front = 5.0 + kDiscs.centres[0].x, wall = 1.0 + kDiscs.radius;
  const std::vector<Point2> ends = corners(corridor.regions[0].regions[0], {5.0, 2.0}, 50.0);
  ASSERT_EQ(ends.size(), 4u);
  for (const Point2& expected :
       {Point2{front - 1.5, wall}, {front + 1.7, wall}, {front + 1.7, 3.5}, {front - 1.5, 3.5}})
    EXPECT_TRUE(
        std::any_of(ends.begin(), ends.end(),
                    [&](const Point2& end) { return std::hypot(end.x - expected.x, end.y - expected.y) < 1e-9; }))
        << expected.x << " " << expected.y;
}

TEST(PolytopeCorridor, AChordThatComesTooCloseIsHeldAndTheDeficitReported)
{
  const Scene scene(above_a_wall());
  const double y = 1.0 + kDiscs.radius - 0.005;
  const std::vector<Pose> knots{{5.0, y, 0.0}, {5.2, y, 0.0}, {5.4, y + 0.1, 0.0}, {5.6, y + 0.1, 0.0}};
  const PolytopeCorridor corridor = polytope_corridor(scene.obstacles, kDiscs, {}, knots);
  Random random(1);
  for_each_region(corridor, knots, {}, [&](const Case& c) {
    expect_chord_inside(c);
    expect_distance_kept(random, scene, c);
    EXPECT_LE(c.region.size(), 4u);
  });
  EXPECT_NEAR(corridor.deficit[0], 0.005, 1e-9);
  EXPECT_NEAR(corridor.deficit[1], 0.005, 1e-9);
  EXPECT_NEAR(corridor.deficit[2], 0.0, 1e-9);
}

TEST(PolytopeCorridor, AGapAsWideAsTheDiscsLeavesTheChord)
{
  OccupancyGrid grid = above_a_wall();
  occupy_block(grid, 0, 40, 200, 20);  // from y = 2 on: 1 m wide
  const DiscCover discs{{{0.25, 0.0}, {-0.25, 0.0}}, 0.5};
  const std::vector<Pose> knots{{5.0, 1.5, 0.0}, {5.2, 1.5, 0.0}};
  const PolytopeCorridor corridor = polytope_corridor(ObstacleRectangles(ObstacleMap(grid)), discs, {}, knots);
  ASSERT_EQ(corridor.status, CorridorStatus::succeeded);
  EXPECT_NEAR(corridor.deficit[0], 0.0, 1e-9);
  for (double x : {4.0, 5.0, 6.0}) EXPECT_LE(excess(corridor.regions[1].regions[0], {x, 1.5, 0.0}), 1e-9);
  EXPECT_GE(excess(corridor.regions[1].regions[0], {5.0, 1.501, 0.0}), 0.0009);
  EXPECT_GE(excess(corridor.regions[1].regions[0], {5.0, 1.499, 0.0}), 0.0009);
}

TEST(PolytopeCorridor, KnotsThatCoincideGetARegionAroundThePoint)
{
  const ObstacleRectangles obstacles{ObstacleMap(above_a_wall())};
  const std::vector<Pose> knots(3, Pose{5.0, 2.0, 1.0});
  const PolytopeCorridor corridor = polytope_corridor(obstacles, kDiscs, {}, knots);
  for_each_region(corridor, knots, {}, [](const Case& c) {
    expect_chord_inside(c);
    EXPECT_GE(c.region.size(), 3u);
  });
}

TEST(PolytopeCorridor, AReferenceInAnObstacleOrOutsideTheMapIsReported)
{
  const ObstacleRectangles obstacles{ObstacleMap(above_a_wall())};
  const Pose good{5.0, 5.0, 0.0};
  const double far = 1e300;
  for (const Pose& bad : {Pose{5.0, 0.5, 0.0}, Pose{5.0, 1.0, 0.0}, Pose{-3.0, 5.0, 0.0}, Pose{5.0, 12.0, 0.0},
                          Pose{10.0, 5.0, 0.0}, Pose{far, far, 0.0}, Pose{-far, far, 1.0}})
  {
    const PolytopeCorridor corridor = polytope_corridor(obstacles, kDiscs, {}, {good, good, bad});
    EXPECT_EQ(corridor.status, CorridorStatus::in_collision) << bad.x << " " << bad.y;
    EXPECT_NE(corridor.message.find("knots 1 and 2"), std::string::npos) << corridor.message;
    EXPECT_TRUE(corridor.regions.empty() && corridor.deficit.empty());
  }
}

TEST(PolytopeCorridor, AChordThroughAnObstacleIsReportedThoughItsEndsAreFree)
{
  OccupancyGrid grid = free_area(10.0, 10.0, 0.05);
  occupy_block(grid, 100, 100, 1, 1);
  const PolytopeCorridor corridor =
      polytope_corridor(ObstacleRectangles(ObstacleMap(grid)), kDiscs, {}, {{4.0, 5.02, 0.0}, {6.0, 5.02, 0.0}});
  EXPECT_EQ(corridor.status, CorridorStatus::in_collision);
}

TEST(PolytopeCorridor, UnusableQuestionsAreRefusedWithASentence)
{
  const ObstacleRectangles obstacles{ObstacleMap(above_a_wall())};
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const std::vector<Pose> good{{5.0, 5.0, 0.0}, {5.2, 5.0, 0.0}};
  const auto refuses = [&](const std::vector<Pose>& knots, const std::vector<double>& shrink) {
    const PolytopeCorridor corridor = polytope_corridor(obstacles, kDiscs, {}, knots, shrink);
    return corridor.status == CorridorStatus::invalid_input && !corridor.message.empty();
  };
  EXPECT_FALSE(refuses(good, {}));
  EXPECT_TRUE(refuses({}, {}));
  EXPECT_TRUE(refuses({good[0]}, {}));
  for (double value : {nan, infinity, -infinity})
  {
    EXPECT_TRUE(refuses({good[0], {value, 5.0, 0.0}}, {}));
    EXPECT_TRUE(refuses({good[0], {5.0, value, 0.0}}, {}));
    EXPECT_TRUE(refuses({good[0], {5.0, 5.0, value}}, {}));
    EXPECT_TRUE(refuses(good, {value}));
  }
  EXPECT_TRUE(refuses(good, {-0.1}));
  EXPECT_TRUE(refuses(good, {0.1, 0.1}));
}

TEST(PolytopeCorridor, OptionsOutOfRangeThrow)
{
  const ObstacleRectangles obstacles{ObstacleMap(above_a_wall())};
  const auto build = [&](double range, int planes) {
    polytope_corridor(obstacles, kDiscs, PolytopeOptions{range, planes}, {{5.0, 5.0, 0.0}, {5.2, 5.0, 0.0}});
  };
  for (double range : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(build(range, 12), std::invalid_argument) << range;
  EXPECT_THROW(build(2.0, 3), std::invalid_argument);
  EXPECT_NO_THROW(build(2.0, 4));
}

}  // namespace
}  // namespace fourwis
