#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "../support/grids.h"
#include "fourwis_navigation/map/obstacle_map.h"

namespace fourwis
{
namespace
{

/// What a grid is refused with, or nothing.
template <typename Check>
std::string rejection(const Check& check)
{
  try
  {
    check();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

void expect_rejected(const OccupancyGrid& grid, const std::string& field)
{
  EXPECT_NE(rejection([&] { check_grid(grid); }).find(field), std::string::npos)
      << rejection([&] { check_grid(grid); });
  EXPECT_NE(rejection([&] { ObstacleMap map(grid); }).find(field), std::string::npos) << field;
}

TEST(CheckGrid, AcceptsWhatIsUsable)
{
  EXPECT_EQ(rejection([] { check_grid(free_grid(1, 1, 1e-3)); }), "");
  EXPECT_EQ(rejection([] { check_grid(free_grid(30, 2, 5.0, {-1e4, 1e4, 100.0})); }), "");
}

TEST(CheckGrid, RejectsGridsWithoutCells)
{
  for (int size : {0, -1, std::numeric_limits<int>::min()})
  {
    OccupancyGrid grid = free_grid(3, 3, 0.1);
    grid.width = size;
    expect_rejected(grid, "width");
    grid.width = 3;
    grid.height = size;
    expect_rejected(grid, "height");
  }
  expect_rejected({}, "width");
}

TEST(CheckGrid, RejectsDataOfAnotherSize)
{
  for (std::size_t cells : {0u, 1u, 11u, 13u, 1000u})
  {
    OccupancyGrid grid = free_grid(4, 3, 0.1);
    grid.data.resize(cells);
    expect_rejected(grid, "data");
  }
  OccupancyGrid huge = free_grid(4, 4, 0.1);
  huge.width = huge.height = std::numeric_limits<int>::max();
  expect_rejected(huge, "data");
}

TEST(CheckGrid, RejectsResolutionsThatAreNotPositiveNumbers)
{
  for (double bad : {0.0, -0.05, std::nan(""), std::numeric_limits<double>::infinity()})
  {
    OccupancyGrid grid = free_grid(4, 3, 0.1);
    grid.resolution = bad;
    expect_rejected(grid, "resolution");
  }
}

TEST(CheckGrid, RejectsResolutionsAndOriginsThatMeanNothing)
{
  for (double bad : {1e-30, 0.9e-9, 1.1e9, 1e30})
  {
    OccupancyGrid grid = free_grid(4, 3, 0.1);
    grid.resolution = bad;
    expect_rejected(grid, "resolution");
  }
  for (double bad : {1e300, -1.1e12})
    for (const Pose& origin : {Pose{bad, 0.0, 0.0}, Pose{0.0, bad, 0.0}, Pose{0.0, 0.0, bad}})
      expect_rejected(free_grid(4, 3, 0.1, origin), "origin");
  EXPECT_NO_THROW(check_grid(free_grid(4, 3, 0.1, {5e9, -5e9, 0.3})));
}

TEST(CheckGrid, RejectsOriginsThatAreNotFinite)
{
  for (double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
    for (const Pose& origin : {Pose{bad, 0.0, 0.0}, Pose{0.0, bad, 0.0}, Pose{0.0, 0.0, bad}})
      expect_rejected(free_grid(4, 3, 0.1, origin), "origin");
}

}  // namespace
}  // namespace fourwis
