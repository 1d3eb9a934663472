#pragma once

#include "../support/grids.h"

namespace fourwis
{

/// Free ground of 6 m by 4 m in cells of 2 cm, walled in; below y = 1 m is wall but for a slot of 1.4 m, from x = 2.3 m on.
inline OccupancyGrid slot_hall()
{
  OccupancyGrid grid = free_area(6.0, 4.0, 0.02);
  occupy_block(grid, 0, 0, 115, 50);
  occupy_block(grid, 185, 0, 115, 50);
  wall_in(grid, 2, 2, 296, 196, 2);
  return grid;
}

/// A hall of 6 m by 4 m in cells of 1 cm that a wall of 10 cm divides, with a gap [cells] in the middle.
inline OccupancyGrid gap_hall(int gap)
{
  OccupancyGrid grid = free_area(6.0, 4.0, 0.01);
  occupy_block(grid, 295, 0, 10, 400);
  for (int row = 166; row < 166 + gap; ++row)
    for (int column = 295; column < 305; ++column) cell(grid, column, row) = 0;
  return grid;
}

/// Corridors of 1.4 m between walls in a square of 12 m: a way of some 40 m from one corner to the opposite one.
inline OccupancyGrid maze(const Pose& origin = {})
{
  OccupancyGrid grid = free_area(12.0, 12.0, 0.1, origin);
  wall_in(grid, 1, 1, 118, 118);
  for (int wall = 0; wall < 7; ++wall)
  {
    // Walls from the left and from the right in turn; every other one has a second opening that is too narrow.
    const int row = 15 * (wall + 1);
    occupy_block(grid, wall % 2 == 0 ? 0 : 16, row, 104, 1);
    if (wall % 2 == 0)
      for (int column = 40; column < 45; ++column) cell(grid, column, row) = 0;
  }
  // Posts at the walls, now on one side and now on the other, to go round.
  for (const auto& [column, row] : {std::pair(60, 11), {30, 16}, {80, 41}, {55, 46}, {35, 71}, {75, 76}, {50, 101}})
    occupy_block(grid, column, row, 3, 4);
  return grid;
}

}  // namespace fourwis
