#include "cell_rectangles.h"

#include <algorithm>
#include <map>
#include <utility>

namespace fourwis
{
namespace
{

using Run = std::pair<int, int>;  ///< columns [first, second) of one row
using Open = std::map<Run, int>;  ///< runs that reach up to the current row -> the row where they began

std::vector<Run> runs_of_row(const OccupancyGrid& grid, int row, const std::function<bool(std::int8_t)>& wanted)
{
  std::vector<Run> runs;
  for (int column = 0; column < grid.width; ++column)
  {
    if (!wanted(grid.at(column, row))) continue;
    if (!runs.empty() && runs.back().second == column)
      ++runs.back().second;
    else
      runs.emplace_back(column, column + 1);
  }
  return runs;
}

}  // namespace

std::vector<CellRectangle> cell_rectangles(const OccupancyGrid& grid, const std::function<bool(std::int8_t)>& wanted)
{
  std::vector<CellRectangle> rectangles;
  Open open;
  for (int row = 0; row <= grid.height; ++row)
  {
    Open reaching;
    if (row < grid.height)
    {
      for (const Run& run : runs_of_row(grid, row, wanted))
      {
        const auto below = open.find(run);
        reaching[run] = below == open.end() ? row : below->second;
        if (below != open.end()) open.erase(below);
      }
    }
    for (const auto& [run, first_row] : open) rectangles.push_back({run.first, first_row, run.second, row});
    open = std::move(reaching);
  }
  return rectangles;
}

CellRectangle known_block(const OccupancyGrid& grid)
{
  CellRectangle block{grid.width, grid.height, 0, 0};
  for (const CellRectangle& part : cell_rectangles(grid, [](std::int8_t cell) { return cell >= 0 && cell <= 100; }))
  {
    block.left = std::min(block.left, part.left);
    block.bottom = std::min(block.bottom, part.bottom);
    block.right = std::max(block.right, part.right);
    block.top = std::max(block.top, part.top);
  }
  return block.left < block.right ? block : CellRectangle{0, 0, grid.width, grid.height};
}

}  // namespace fourwis
