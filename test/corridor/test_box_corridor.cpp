#include "fourwis_navigation/corridor/box_corridor.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <stdexcept>

#include "corridor_fixture.h"
#include "fourwis_navigation/search/search.h"
#include "fourwis_navigation/segment/segment.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 5;
constexpr double kRounding = 1e-9;
const TwoDiscs kDiscs = two_discs(Robot());

/// One box and what it is about.
struct Case
{
  Box box;
  Pose waypoint;
  Pose motion;  ///< x, y: the way of the disc centre to its next place
  double keep;  ///< distance to keep [m]
};

template <typename Visit>
void for_each_box(const Scene& scene, const BoxCorridorResult& corridor, const std::vector<Pose>& knots, Visit visit)
{
  ASSERT_EQ(corridor.status, CorridorStatus::succeeded) << corridor.message;
  ASSERT_EQ(corridor.regions.front.size(), knots.size());
  ASSERT_EQ(corridor.regions.rear.size(), knots.size());
  ASSERT_EQ(corridor.deficit.size(), knots.size());
  for (std::size_t i = 0; i < knots.size(); ++i)
    for (bool is_front : {true, false})
    {
      SCOPED_TRACE("knot " + std::to_string(i) + (is_front ? ", front" : ", rear"));
      const Pose waypoint = disc_centre(knots[i], is_front ? kDiscs.offset : -kDiscs.offset);
      const std::size_t from = std::min(i, knots.size() - 2);
      const Pose begin = disc_centre(knots[from], is_front ? kDiscs.offset : -kDiscs.offset);
      const Pose end = disc_centre(knots[from + 1], is_front ? kDiscs.offset : -kDiscs.offset);
      visit(Case{(is_front ? corridor.regions.front : corridor.regions.rear)[i], waypoint,
                 Pose{end.x - begin.x, end.y - begin.y, 0.0},
                 std::min(kDiscs.radius, scene.every.distance(waypoint.x, waypoint.y))});
      if (testing::Test::HasFailure()) return;
    }
}

/// Least distance from an obstacle to points of a box at most `step` apart [m].
double sampled_distance(const EveryObstacle& obstacles, const Box& box, double step)
{
  const double width = box.x_max - box.x_min, height = box.y_max - box.y_min;
  const int columns = static_cast<int>(width / step) + 1, rows = static_cast<int>(height / step) + 1;
  double least = INFINITY;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i)
      least = std::min(least, obstacles.distance(box.x_min + width * i / columns, box.y_min + height * j / rows));
  return least;
}

/// The three outer edges of what a box gains when a side is moved outward by `step`: right, left, up, down.
std::array<Box, 3> gained_edges(const Box& b, std::size_t side, double step)
{
  const double x = side == 0 ? b.x_max : b.x_min, y = side == 2 ? b.y_max : b.y_min;
  const double out = side % 2 == 0 ? step : -step;
  const double x_low = std::min(x, x + out), x_high = std::max(x, x + out);
  const double y_low = std::min(y, y + out), y_high = std::max(y, y + out);
  if (side < 2)
    return {
        {{x + out, b.y_min, x + out, b.y_max}, {x_low, b.y_min, x_high, b.y_min}, {x_low, b.y_max, x_high, b.y_max}}};
  return {{{b.x_min, y + out, b.x_max, y + out}, {b.x_min, y_low, b.x_min, y_high}, {b.x_max, y_low, b.x_max, y_high}}};
}

/// Drives about random maps, grids straight and turned. Few knots: brute force is slow.
struct RandomBoxes : testing::Test
{
  template <typename Visit>
  void for_drives(int drives, Visit visit)
  {
    for (int k = 0; k < drives; ++k)
    {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", drive " + std::to_string(k));
      const Scene scene(corridor_grid(random, k));
      std::vector<Pose> knots = random_knots(random, scene.site.checker, scene.site.robot);
      if (knots.size() > 8) knots.resize(8);
      visit(scene, knots);
      if (HasFailure()) return;
    }
  }

  Random random{kSeed};
  BoxOptions options{0.5, 0.05, 1.5};
};

TEST_F(RandomBoxes, BoxesHoldTheirWaypointsAndKeepTheirDistance)
{
  for_drives(24, [&](const Scene& scene, const std::vector<Pose>& knots) {
    for_each_box(scene, box_corridor(scene.obstacles, kDiscs, options, knots), knots, [&](const Case& c) {
      EXPECT_TRUE(c.waypoint.x >= c.box.x_min && c.waypoint.x <= c.box.x_max);
      EXPECT_TRUE(c.waypoint.y >= c.box.y_min && c.waypoint.y <= c.box.y_max);
      EXPECT_GE(sampled_distance(scene.every, c.box, 0.1), c.keep - kRounding);
    });
  });
}

TEST_F(RandomBoxes, NoSideCanBeMovedByAFineStep)
{
  for_drives(24, [&](const Scene& scene, const std::vector<Pose>& knots) {
    for_each_box(scene, box_corridor(scene.obstacles, kDiscs, options, knots), knots, [&](const Case& c) {
      const double reach[] = {c.box.x_max - c.waypoint.x, c.waypoint.x - c.box.x_min, c.box.y_max - c.waypoint.y,
                              c.waypoint.y - c.box.y_min};
      for (std::size_t side = 0; side < 4; ++side)
      {
        EXPECT_LE(reach[side], options.max_expansion + kRounding);
        if (reach[side] + options.fine_step > options.max_expansion + kRounding) continue;
        double least = INFINITY;
        for (const Box& edge : gained_edges(c.box, side, options.fine_step))
          least = std::min(least, sampled_distance(scene.every, edge, 0.005));
        // Between samples an obstacle is nearer by half a step at most.
        EXPECT_LT(least, c.keep + 0.0026) << "side " << side;
      }
    });
  });
}

TEST_F(RandomBoxes, SidesLieAWholeNumberOfStepsFromTheWaypoint)
{
  for_drives(24, [&](const Scene& scene, const std::vector<Pose>& knots) {
    for_each_box(scene, box_corridor(scene.obstacles, kDiscs, options, knots), knots, [&](const Case& c) {
      for (double reach : {c.box.x_max - c.waypoint.x, c.waypoint.x - c.box.x_min, c.box.y_max - c.waypoint.y,
                           c.waypoint.y - c.box.y_min})
        EXPECT_NEAR(std::remainder(reach, options.fine_step), 0.0, 1e-9);
    });
  });
}

/// Algorithm 2 word by word, on a grid that is not turned, looking at every cell.
Box algorithm_2(const OccupancyGrid& grid, const Case& c, const BoxOptions& options)
{
  const auto collides = [&](const Box& box) {
    const double x = grid.origin.x, y = grid.origin.y, r = grid.resolution, keep = c.keep - kRounding;
    if (box.x_min - x < keep || box.y_min - y < keep || x + grid.width * r - box.x_max < keep ||
        y + grid.height * r - box.y_max < keep)
      return true;
    for (int j = 0; j < grid.height; ++j)
      for (int i = 0; i < grid.width; ++i)
        if (ObstacleRule().is_obstacle(grid.at(i, j)) &&
            std::hypot(std::max({x + i * r - box.x_max, box.x_min - x - (i + 1) * r, 0.0}),
                       std::max({y + j * r - box.y_max, box.y_min - y - (j + 1) * r, 0.0})) < keep)
          return true;
    return false;
  };
  // Directions 0: +x, 1: +y, 2: -x, 3: -y.
  const auto expand = [](Box box, int q, double step) {
    (q == 0 ? box.x_max : q == 1 ? box.y_max : q == 2 ? box.x_min : box.y_min) += q < 2 ? step : -step;
    return box;
  };
  const int x = c.motion.x >= 0.0 ? 0 : 2, y = c.motion.y >= 0.0 ? 1 : 3;
  const bool along_x = std::abs(c.motion.x) >= std::abs(c.motion.y);
  const int sorted[] = {along_x ? x : y, along_x ? y : x, ((along_x ? x : y) + 2) % 4, ((along_x ? y : x) + 2) % 4};
  double total[4] = {}, step[4];
  std::fill(step, step + 4, options.coarse_step);
  bool blocked[4] = {};
  Box box{c.waypoint.x, c.waypoint.y, c.waypoint.x, c.waypoint.y};
  while (!(blocked[0] && blocked[1] && blocked[2] && blocked[3]))
    for (int q : sorted)
    {
      if (blocked[q]) continue;
      const Box test = expand(box, q, step[q]);
      if (collides(test) || total[q] + step[q] > options.max_expansion + kRounding)
      {
        blocked[q] = step[q] != options.coarse_step;
        step[q] = options.fine_step;
      }
      else
      {
        box = test;
        total[q] += step[q];
      }
    }
  return box;
}

TEST_F(RandomBoxes, BoxesAreThoseOfAlgorithm2)
{
  int compared = 0;
  for_drives(16, [&](const Scene& scene, const std::vector<Pose>& knots) {
    if (scene.site.grid.origin.theta != 0.0) return;
    const BoxCorridorResult corridor = box_corridor(scene.obstacles, kDiscs, BoxOptions(), knots);
    for_each_box(scene, corridor, knots, [&](const Case& c) {
      const Box expected = algorithm_2(scene.site.grid, c, BoxOptions());
      EXPECT_NEAR(c.box.x_min, expected.x_min, kRounding);
      EXPECT_NEAR(c.box.y_min, expected.y_min, kRounding);
      EXPECT_NEAR(c.box.x_max, expected.x_max, kRounding);
      EXPECT_NEAR(c.box.y_max, expected.y_max, kRounding);
      ++compared;
    });
  });
  EXPECT_GT(compared, 50);
}

TEST(BoxPaths, PathsOfTheSearchGetBoxesWithoutADeficitToSpeakOf)
{
  Random random(kSeed);
  int paths = 0;
  for (int k = 0; k < 12; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", path " + std::to_string(k));
    const Scene scene(corridor_grid(random, k));
    PlanRequest request;
    request.start = free_pose(random, scene.site.checker);
    request.goal = free_pose(random, scene.site.checker);
    const SearchResult found = Search({scene.site.checker, request.start, request.goal}).find({}, request.modes);
    if (found.status != PlanStatus::succeeded) continue;
    ++paths;
    for (const Segment& segment : split_at_switches(found.path, scene.site.robot, 0.2))
    {
      const BoxCorridorResult corridor = box_corridor(scene.obstacles, kDiscs, BoxOptions(), segment.knots);
      ASSERT_EQ(corridor.status, CorridorStatus::succeeded) << corridor.message;
      for (double deficit : corridor.deficit) EXPECT_LE(deficit, scene.site.checker.stride() / 2.0);
    }
  }
  EXPECT_GE(paths, 8);
}

TEST(BoxCorridor, InTheOpenABoxReachesTheGreatestExpansionOnAllSides)
{
  const ObstacleRectangles obstacles{ObstacleMap(free_area(20.0, 20.0, 0.1))};
  const BoxCorridorResult corridor =
      box_corridor(obstacles, kDiscs, BoxOptions(), {{10.0, 10.0, 0.0}, {10.2, 10.0, 0.0}});
  ASSERT_EQ(corridor.status, CorridorStatus::succeeded);
  const Box& box = corridor.regions.rear[0];
  EXPECT_NEAR(box.x_min, 10.0 - kDiscs.offset - 5.0, kRounding);
  EXPECT_NEAR(box.x_max, 10.0 - kDiscs.offset + 5.0, kRounding);
  EXPECT_NEAR(box.y_min, 5.0, kRounding);
  EXPECT_NEAR(box.y_max, 15.0, kRounding);
}

TEST(BoxCorridor, TheMotionDecidesWhichSideGrowsFirst)
{
  // An obstacle ahead to the left: the side that comes first shuts out the other one.
  OccupancyGrid grid = free_area(20.0, 20.0, 0.1);
  occupy_block(grid, 110, 110, 90, 90);
  const ObstacleRectangles obstacles{ObstacleMap(grid)};
  const TwoDiscs discs{0.0, 0.4};
  const auto box = [&](const Pose& to) {
    return box_corridor(obstacles, discs, BoxOptions(), {{10.55, 10.55, 0.0}, to}).regions.front.at(0);
  };
  const Box along_x = box({10.75, 10.60, 0.0}), along_y = box({10.60, 10.75, 0.0});
  EXPECT_NEAR(along_x.x_max, 15.55, kRounding);
  EXPECT_LT(along_x.y_max, 10.6 + kRounding);
  EXPECT_NEAR(along_y.y_max, 15.55, kRounding);
  EXPECT_LT(along_y.x_max, 10.6 + kRounding);
}

TEST(BoxCorridor, AWaypointThatIsTooCloseKeepsItsOwnDistanceAndTheDeficitIsReported)
{
  const Scene scene(above_a_wall());
  const double y = 1.0 + kDiscs.radius - 0.013;
  const std::vector<Pose> knots{{5.0, y, 0.0}, {5.2, y + 0.2, 0.0}};
  const BoxCorridorResult corridor = box_corridor(scene.obstacles, kDiscs, BoxOptions(), knots);
  ASSERT_EQ(corridor.status, CorridorStatus::succeeded);
  EXPECT_NEAR(corridor.deficit[0], 0.013, 1e-9);
  EXPECT_NEAR(corridor.deficit[1], 0.0, 1e-9);
  EXPECT_NEAR(corridor.regions.front[0].y_min, y, kRounding);
  EXPECT_GE(sampled_distance(scene.every, corridor.regions.front[0], 0.1), kDiscs.radius - 0.013 - kRounding);
}

TEST(BoxCorridor, KnotsThatCoincideGetBoxes)
{
  const Scene scene(above_a_wall());
  const std::vector<Pose> knots(3, Pose{5.0, 2.0, 1.0});
  for_each_box(scene, box_corridor(scene.obstacles, kDiscs, BoxOptions(), knots), knots,
               [](const Case& c) { EXPECT_GT(c.box.x_max - c.box.x_min, 1.0); });
}

TEST(BoxCorridor, AWaypointInAnObstacleOrOutsideTheMapIsReported)
{
  const ObstacleRectangles obstacles{ObstacleMap(above_a_wall())};
  const Pose good{5.0, 5.0, 0.0};
  for (const Pose& bad : {Pose{5.0, 0.5, 0.0}, Pose{5.0, 1.0, 0.0}, Pose{-3.0, 5.0, 0.0}, Pose{5.0, 12.0, 0.0},
                          Pose{1e300, 1e300, 0.0}, Pose{1e300, -1e300, 1.0}})
  {
    const BoxCorridorResult corridor = box_corridor(obstacles, kDiscs, BoxOptions(), {good, bad});
    EXPECT_EQ(corridor.status, CorridorStatus::in_collision) << bad.x << " " << bad.y;
    EXPECT_NE(corridor.message.find("knot 1"), std::string::npos) << corridor.message;
    EXPECT_TRUE(corridor.regions.front.empty() && corridor.regions.rear.empty() && corridor.deficit.empty());
  }
}

TEST(BoxCorridor, UnusableKnotsAreRefusedWithASentence)
{
  const ObstacleRectangles obstacles{ObstacleMap(above_a_wall())};
  const Pose good{5.0, 5.0, 0.0};
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const std::vector<Pose>& knots : std::vector<std::vector<Pose>>{
           {}, {good}, {good, {nan, 5.0, 0.0}}, {{5.0, infinity, 0.0}, good}, {good, good, {5.0, 5.0, nan}}})
  {
    const BoxCorridorResult corridor = box_corridor(obstacles, kDiscs, BoxOptions(), knots);
    EXPECT_EQ(corridor.status, CorridorStatus::invalid_input);
    EXPECT_FALSE(corridor.message.empty());
  }
}

TEST(BoxCorridor, OptionsOutOfRangeThrow)
{
  const ObstacleRectangles obstacles{ObstacleMap(above_a_wall())};
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto build = [&](const BoxOptions& options) {
    box_corridor(obstacles, kDiscs, options, {{5.0, 5.0, 0.0}, {5.2, 5.0, 0.0}});
  };
  EXPECT_NO_THROW(build({0.5, 0.5, 0.5}));
  for (const BoxOptions& options : {BoxOptions{0.5, 0.0, 5.0}, BoxOptions{0.5, -0.1, 5.0}, BoxOptions{0.5, nan, 5.0},
                                    BoxOptions{0.04, 0.05, 5.0}, BoxOptions{nan, 0.05, 5.0}, BoxOptions{0.5, 0.05, 0.4},
                                    BoxOptions{0.5, 0.05, infinity}, BoxOptions{0.5, 0.05, nan}})
    EXPECT_THROW(build(options), std::invalid_argument)
        << options.coarse_step << " " << options.fine_step << " " << options.max_expansion;
}

}  // namespace
}  // namespace fourwis
