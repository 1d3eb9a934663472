#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/occupancy_grid.h"
#include "random.h"

namespace fourwis
{

inline OccupancyGrid free_grid(int width, int height, double resolution, const Pose& origin = {})
{
  OccupancyGrid grid;
  grid.width = width;
  grid.height = height;
  grid.resolution = resolution;
  grid.origin = origin;
  grid.data.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  return grid;
}

/// A free grid of about the given size in metres.
inline OccupancyGrid free_area(double length, double width, double resolution, const Pose& origin = {})
{
  const auto cells = [&](double metres) { return static_cast<int>(std::lround(metres / resolution)); };
  return free_grid(cells(length), cells(width), resolution, origin);
}

inline std::int8_t& cell(OccupancyGrid& grid, int column, int row)
{
  return grid
      .data[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width) + static_cast<std::size_t>(column)];
}

inline void occupy(OccupancyGrid& grid, int column, int row, std::int8_t value = 100)
{
  cell(grid, column, row) = value;
}

/// Occupies the cells from (column, row) on, as far as they lie in the grid.
inline void occupy_block(OccupancyGrid& grid, int column, int row, int columns, int rows)
{
  for (int j = std::max(0, row); j < std::min(grid.height, row + rows); ++j)
    for (int i = std::max(0, column); i < std::min(grid.width, column + columns); ++i) occupy(grid, i, j);
}

/// Occupies the cells of a ring around the block from (column, row) on. The block itself does not change.
inline void wall_in(OccupancyGrid& grid, int column, int row, int columns, int rows, int thickness = 1)
{
  const int t = thickness;
  occupy_block(grid, column - t, row - t, columns + 2 * t, t);
  occupy_block(grid, column - t, row + rows, columns + 2 * t, t);
  occupy_block(grid, column - t, row, t, rows);
  occupy_block(grid, column + columns, row, t, rows);
}

/// Each cell occupied with the given probability.
inline OccupancyGrid scattered(Random& random, int width, int height, double resolution, const Pose& origin,
                               double probability)
{
  OccupancyGrid grid = free_grid(width, height, resolution, origin);
  for (std::int8_t& value : grid.data) value = random.chance(probability) ? 100 : 0;
  return grid;
}

/// Boxes of 0.1 to 0.8 m on a square of the given side [m].
inline OccupancyGrid clutter(Random& random, double side, double resolution, int boxes, const Pose& origin = {})
{
  OccupancyGrid grid = free_area(side, side, resolution, origin);
  const int least = std::max(1, static_cast<int>(0.1 / resolution)), most = static_cast<int>(0.8 / resolution);
  for (int k = 0; k < boxes; ++k)
    occupy_block(grid, random.whole(0, grid.width - 1), random.whole(0, grid.height - 1), random.whole(least, most),
                 random.whole(least, most));
  return grid;
}

/// A random free pose on the map, which must have many.
inline Pose free_pose(Random& random, const CollisionChecker& checker)
{
  const ObstacleMap& map = checker.map();
  for (;;)
  {
    const Pose in_grid = {random.between(0.0, map.width() * map.resolution()),
                          random.between(0.0, map.height() * map.resolution()), random.angle()};
    Pose pose = compose(map.origin(), in_grid);
    pose.theta = wrap_angle(pose.theta);
    if (checker.is_free(pose)) return pose;
  }
}

/// A grid with everything that is computed from it.
struct Site
{
  explicit Site(const OccupancyGrid& occupancy, const Robot& the_robot = {})
    : grid(occupancy),
      robot(the_robot),
      map(grid),
      checker(map, robot)
  {}
  Site(const Site&) = delete;
  Site& operator=(const Site&) = delete;

  const OccupancyGrid grid;
  const Robot robot;
  const ObstacleMap map;
  const CollisionChecker checker;
};

}  // namespace fourwis
