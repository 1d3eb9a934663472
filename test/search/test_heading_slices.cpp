#include "search/heading_slices.h"

#include <gtest/gtest.h>

#include <tuple>

#include "../support/grids.h"
#include "fourwis_navigation/map/body_overlap.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 33;
/// Accuracy of overlaps [m].
constexpr double kTouch = 1e-6;

/// A rectangle whose middle may lie far from C.
ConvexPolygon rectangle(double rear, double front, double right, double left)
{
  return {{front, left}, {rear, left}, {rear, right}, {front, right}};
}

/// Bodies of any shape: about C, behind it, beside it, and one that C does not even lie in.
std::vector<ConvexPolygon> bodies()
{
  return {body_of({}),
          rectangle(-0.2, 0.8, -0.31, 0.31),
          rectangle(-0.5, 0.5, -0.1, 0.7),
          rectangle(0.3, 0.7, -0.2, 0.1),
          {{0.6, 0.0}, {0.1, 0.4}, {-0.5, 0.2}, {-0.4, -0.3}, {0.2, -0.35}}};
}

/// Calls visit(map, spacing, body, random) for cluttered maps turned any way, several spacings and all bodies.
template <typename Visit>
void for_maps(Visit visit)
{
  Random random(kSeed);
  for (const auto& [resolution, spacing] :
       {std::pair(0.05, 0.025), {0.05, 0.05}, {0.05, 0.08}, {0.1, 0.05}, {0.03, 0.11}, {0.15, 0.2}})
    for (const ConvexPolygon& body : bodies())
    {
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", resolution " + std::to_string(resolution) + ", spacing " +
                   std::to_string(spacing));
      // More than 64 columns: more than one word of bits.
      const OccupancyGrid grid = clutter(random, random.between(4.0, 6.0), resolution, 8, random.pose(10.0));
      const ObstacleMap map(grid);
      visit(map, spacing, body, random);
      if (testing::Test::HasFatalFailure()) return;
    }
}

bool has(HeadingSet set, int bin)
{
  return (set & heading_bit(bin)) != 0;
}

TEST(HeadingSlices, AgreeWithTheBodyAtThePointsOfTheLattice)
{
  int clear = 0, blocked = 0;
  for_maps([&](const ObstacleMap& map, double spacing, const ConvexPolygon& body, Random& random) {
    const HeadingSlices slices(map, spacing, body, {});
    const ConvexPolygon larger = grown(body, kTouch), smaller = grown(body, -kTouch);
    for (int k = 0; k < 5000; ++k)
    {
      const int i = random.whole(0, slices.columns() - 1), j = random.whole(0, slices.rows() - 1);
      const int bin = random.whole(0, kHeadings - 1);
      Pose pose = compose(map.origin(), {i * spacing, j * spacing, 0.0});
      pose.theta = heading_of(bin);
      const bool is_set = has(slices.at(i, j), bin);
      ASSERT_TRUE(is_set || !is_clear(map, larger, placed(pose))) << text(pose);
      ASSERT_TRUE(!is_set || is_clear(map, smaller, placed(pose))) << text(pose);
      ++(is_set ? clear : blocked);
    }
  });
  EXPECT_GT(clear, 5000);
  EXPECT_GT(blocked, 5000);
}

/// Each pose on the grid has a point within half the spacing.
TEST(HeadingSlices, HaveAPointOnOrBeyondEachSideOfTheGrid)
{
  for (const auto& [spacing, columns, rows] : {std::tuple(0.1, 21, 11), {0.025, 81, 41}, {0.3, 8, 5}})
  {
    const HeadingSlices slices(ObstacleMap(free_area(2.0, 1.0, 0.1)), spacing, body_of({}), {});
    EXPECT_EQ(slices.columns(), columns);
    EXPECT_EQ(slices.rows(), rows);
    EXPECT_EQ(slices.at(-1, 0) | slices.at(0, -1) | slices.at(columns, 0) | slices.at(0, rows), 0u);
  }
}

/// Half a turn is no symmetry of a body that is not centred at C.
TEST(HeadingSlices, TellAHeadingFromItsOpposite)
{
  OccupancyGrid grid = free_area(4.0, 2.0, 0.05);
  occupy_block(grid, 50, 0, 30, 40);
  const HeadingSlices slices(ObstacleMap(grid), 0.1, rectangle(-0.2, 0.8, -0.3, 0.3), {});
  const HeadingSet beside_wall = slices.at(21, 10);  // 0.4 m in front of it
  EXPECT_FALSE(has(beside_wall, heading_bin(0.0)));
  EXPECT_TRUE(has(beside_wall, heading_bin(M_PI)));
}

TEST(HeadingSlices, StopWhenInterrupted)
{
  const std::atomic<bool> cancelled{true};
  const HeadingSlices slices(ObstacleMap(free_area(2.0, 2.0, 0.1)), 0.1, body_of({}), Interrupt(&cancelled));
  EXPECT_EQ(slices.at(0, 0), kAllHeadings) << "nothing was looked at";
}

TEST(HeadingBin, IsThatOfTheNearestHeadingOfAWholeTurn)
{
  Random random(kSeed);
  for (int bin = 0; bin < kHeadings; ++bin)
    for (int turns : {-3, -1, 0, 1, 7})
      EXPECT_EQ(heading_bin(heading_of(bin) + turns * 2.0 * M_PI + random.between(-0.49, 0.49) * kBin), bin);
}

TEST(HeadingSets, GrowByTheirNeighboursAroundTheWholeTurn)
{
  EXPECT_EQ(turned_by_one_bin(heading_bit(0)), heading_bit(1) | heading_bit(kHeadings - 1));
  EXPECT_EQ(turned_by_one_bin(heading_bit(kHeadings - 1)), heading_bit(0) | heading_bit(kHeadings - 2));
  EXPECT_EQ(turned_by_one_bin(heading_bit(9)), heading_bit(8) | heading_bit(10));
}

}  // namespace
}  // namespace fourwis
