#include "fourwis_navigation/corridor/obstacle_rectangles.h"

#include <array>
#include <cmath>
#include <cstdint>

namespace fourwis
{
namespace
{

/// Cells along the side of a tile: the bits of a row.
constexpr int kTile = 32;
using TileRow = std::uint32_t;
using TileRows = std::array<TileRow, kTile>;

int tiles_along(int cells)
{
  return (cells + kTile - 1) / kTile;
}

/// Bit i: whether cell (first_column + i, row) is an obstacle.
TileRow read_row(const ObstacleMap& map, int first_column, int row)
{
  TileRow bits = 0;
  const int end = std::min(first_column + kTile, map.width());
  for (int column = map.next_obstacle(first_column, row); column < end; column = map.next_obstacle(column + 1, row))
    bits |= TileRow{1} << (column - first_column);
  return bits;
}

/// The lowest run of set bits: [first, end).
struct BitRun
{
  explicit BitRun(TileRow bits)
  {
    while (!(bits >> first & 1u)) ++first;
    for (end = first; end < kTile && (bits >> end & 1u); ++end) mask |= TileRow{1} << end;
  }

  int first = 0, end = 0;
  TileRow mask = 0;
};

}  // namespace

ObstacleRectangles::ObstacleRectangles(const ObstacleMap& map)
  : origin_(map.origin()),
    cos_(std::cos(origin_.theta)),
    sin_(std::sin(origin_.theta)),
    width_(map.width() * map.resolution()),
    height_(map.height() * map.resolution()),
    tiles_{kTile * map.resolution(), tiles_along(map.width()), tiles_along(map.height())}
{
  for (int row = 0; row < map.height(); row += kTile)
    for (int column = 0; column < map.width(); column += kTile)
    {
      first_in_tile_.push_back(rectangles_.size());
      append_tile(map, column, row);
    }
  first_in_tile_.push_back(rectangles_.size());
}

/// Runs of a row are extended upward as far as the rows above hold the whole run.
void ObstacleRectangles::append_tile(const ObstacleMap& map, int first_column, int first_row)
{
  TileRows rows{};
  const int count = std::min(kTile, map.height() - first_row);
  for (int j = 0; j < count; ++j) rows[static_cast<std::size_t>(j)] = read_row(map, first_column, first_row + j);

  const double side = map.resolution();
  for (int j = 0; j < count; ++j)
    while (rows[static_cast<std::size_t>(j)] != 0)
    {
      const BitRun run(rows[static_cast<std::size_t>(j)]);
      int top = j;
      for (; top < count && (rows[static_cast<std::size_t>(top)] & run.mask) == run.mask; ++top)
        rows[static_cast<std::size_t>(top)] &= ~run.mask;
      rectangles_.push_back({(first_column + run.first) * side, (first_row + j) * side, (first_column + run.end) * side,
                             (first_row + top) * side});
    }
}

Point2 ObstacleRectangles::to_grid(double x, double y) const
{
  const double dx = x - origin_.x, dy = y - origin_.y;
  return {cos_ * dx + sin_ * dy, -sin_ * dx + cos_ * dy};
}

Point2 ObstacleRectangles::to_map(const Point2& point) const
{
  return {origin_.x + cos_ * point.x - sin_ * point.y, origin_.y + sin_ * point.x + cos_ * point.y};
}

HalfPlane ObstacleRectangles::to_map(const HalfPlane& plane) const
{
  const double a = cos_ * plane.a - sin_ * plane.b, b = sin_ * plane.a + cos_ * plane.b;
  return {a, b, plane.c + a * origin_.x + b * origin_.y};
}

}  // namespace fourwis
