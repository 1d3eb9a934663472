#include "search/free_headings.h"

#include <gtest/gtest.h>

#include "../support/grids.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 31;

/// Visits small cluttered maps, turned any way, with cells of several sizes and the larger a margin, and with it a stride
/// between checks, the larger the cells: visit(site, cells, places, random).
template <typename Visit>
void for_sites(Visit visit)
{
  Random random(kSeed);
  for (double resolution : {0.03, 0.05, 0.1, 0.15})
    for (double size : {0.05, 0.08, 0.2})
    {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", resolution " + std::to_string(resolution) + ", cells of " +
                   std::to_string(size));
      Robot robot;
      robot.safety_margin = size;
      const Site site(clutter(random, 4.0, resolution, 4, random.pose(10.0)), robot);
      const CoarseCells cells(site.map, size);
      visit(site, cells, DiscPlaces(site.map, site.checker.least_clearance(), size / 4.0, {}), random);
      if (testing::Test::HasFatalFailure()) return;
    }
}

Pose anywhere(const Site& site, Random& random)
{
  return compose(site.grid.origin, {random.between(-0.2, 4.2), random.between(-0.2, 4.2), random.angle()});
}

/// Of the poses between a free one and another, one whose discs keep just the clearance they have on a free motion.
Pose slid_towards(const Site& site, Pose clear, Pose other)
{
  const TwoDiscs& discs = site.checker.discs();
  for (int k = 0; k < 40; ++k)
  {
    const Pose middle = {(clear.x + other.x) / 2.0, (clear.y + other.y) / 2.0, (clear.theta + other.theta) / 2.0};
    const Pose front = compose(middle, {discs.offset, 0.0, 0.0}), rear = compose(middle, {-discs.offset, 0.0, 0.0});
    const double least = site.checker.least_clearance();
    const bool keeps = site.map.is_clear(front.x, front.y, least) && site.map.is_clear(rear.x, rear.y, least);
    (keeps ? clear : other) = middle;
  }
  return clear;
}

TEST(FreeHeadings, HoldEveryPoseOfAFreeMotionHoweverCloseTheObstaclesAre)
{
  for_sites([](const Site& site, const CoarseCells& cells, const DiscPlaces& places, Random& random) {
    FreeHeadings by_clearance(site.checker, cells), by_places(site.checker, cells, &places);
    for (int k = 0; k < 4000; ++k)
    {
      const Pose pose = slid_towards(site, free_pose(random, site.checker), anywhere(site, random));
      const int cell = cells.index(pose.x, pose.y);
      ASSERT_TRUE(by_clearance[cell] >> heading_bin(pose.theta) & 1u) << text(pose);
      ASSERT_TRUE(by_places[cell] >> heading_bin(pose.theta) & 1u) << text(pose);
    }
  });
}

TEST(FreeHeadings, AreFewerByThePlaces)
{
  for_sites([&](const Site& site, const CoarseCells& cells, const DiscPlaces& places, Random&) {
    FreeHeadings by_clearance(site.checker, cells), by_places(site.checker, cells, &places);
    int fewer = 0;
    for (int cell = 0; cell < static_cast<int>(cells.count()); ++cell)
    {
      ASSERT_EQ(by_places[cell] & ~by_clearance[cell], 0u);
      fewer += by_places[cell] != by_clearance[cell];
    }
    EXPECT_GT(fewer, 5);
  });
}

TEST(DiscPlaces, AreNearWhereverAPointOfTheRectangleIsClear)
{
  for_sites([](const Site& site, const CoarseCells&, const DiscPlaces& places, Random& random) {
    for (int k = 0; k < 4000; ++k)
    {
      const Pose centre = anywhere(site, random);
      const double reach_x = random.between(0.0, 0.3), reach_y = random.between(0.0, 0.3);
      const Pose in_rectangle = {random.between(-reach_x, reach_x), random.between(-reach_y, reach_y), 0.0};
      const Pose point = compose({centre.x, centre.y, site.grid.origin.theta}, in_rectangle);
      if (!site.map.is_clear(point.x, point.y, site.checker.least_clearance())) continue;
      ASSERT_TRUE(places.any_near(centre.x, centre.y, reach_x, reach_y)) << text(centre) << " and " << text(point);
    }
  });
}

TEST(DiscPlaces, AreNotNearWhereNoPointIsAlmostClear)
{
  int far = 0;
  for_sites([&](const Site& site, const CoarseCells& cells, const DiscPlaces& places, Random& random) {
    const double square = cells.size() / 4.0;
    for (int k = 0; k < 4000; ++k)
    {
      const Pose centre = anywhere(site, random);
      const double reach = random.between(0.0, 0.3), corner = M_SQRT2 * (reach + square);
      // A square in reach that was marked has a centre that lacks no more than half its diagonal.
      if (site.map.distance(centre.x, centre.y) + corner >= site.checker.least_clearance() - square) continue;
      ++far;
      ASSERT_FALSE(places.any_near(centre.x, centre.y, reach, reach)) << text(centre);
    }
  });
  EXPECT_GT(far, 1000);
}

}  // namespace
}  // namespace fourwis
