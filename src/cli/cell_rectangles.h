#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"

namespace fourwis
{

/// A block of cells: columns [left, right), rows [bottom, top).
struct CellRectangle
{
  int left, bottom, right, top;
};

/// Disjoint blocks that cover exactly the cells `wanted` holds for. Runs along a row are merged with equal runs of the
/// rows above.
std::vector<CellRectangle> cell_rectangles(const OccupancyGrid& grid, const std::function<bool(std::int8_t)>& wanted);

/// The least block that holds all known cells; the whole grid where there are none.
CellRectangle known_block(const OccupancyGrid& grid);

}  // namespace fourwis
