#include "disc_places.h"

#include <algorithm>
#include <cmath>

namespace fourwis
{
namespace
{

constexpr int kBlock = 16;                ///< squares to a side of the blocks looked at first, a power of two
constexpr double kRounding = 1.0 + 1e-9;  ///< lengths are rounded up by this much

int squares_along(int cells, double resolution, double square)
{
  return std::max(1, static_cast<int>(std::ceil(cells * resolution / square)));
}

}  // namespace

DiscPlaces::DiscPlaces(const ObstacleMap& map, double clearance, double square, const Interrupt& interrupt)
  : map_(map),
    square_(square),
    width_(squares_along(map.width(), map.resolution(), square)),
    height_(squares_along(map.height(), map.resolution(), square)),
    sums_(static_cast<std::size_t>(width_ + 1) * static_cast<std::size_t>(height_ + 1), 0)
{
  for (int row = 0; row < height_ && !interrupt.cancelled() && !interrupt.timed_out(); row += kBlock)
    for (int column = 0; column < width_; column += kBlock) mark(column, row, kBlock, clearance);
  sum_up();
}

void DiscPlaces::mark(int column, int row, int squares, double clearance)
{
  if (column >= width_ || row >= height_) return;
  const double half = squares * square_ / 2.0, to_corner = M_SQRT2 * half * kRounding;
  const Pose centre = compose(map_.origin(), {column * square_ + half, row * square_ + half, 0.0});
  if (!map_.is_clear(centre.x, centre.y, clearance - to_corner)) return;
  if (squares == 1 || map_.is_clear(centre.x, centre.y, clearance + to_corner))
  {
    for (int j = row; j < std::min(row + squares, height_); ++j)
      for (int i = column; i < std::min(column + squares, width_); ++i) sum(i + 1, j + 1) = 1;
    return;
  }
  const int part = squares / 2;
  for (int j : {row, row + part})
    for (int i : {column, column + part}) mark(i, j, part, clearance);
}

void DiscPlaces::sum_up()
{
  for (int row = 1; row <= height_; ++row)
    for (int column = 1; column <= width_; ++column)
      sum(column, row) += sum(column - 1, row) + sum(column, row - 1) - sum(column - 1, row - 1);
}

bool DiscPlaces::any_near(double x, double y, double reach_x, double reach_y) const
{
  double u, v;
  map_.to_cells(x, y, u, v);
  const double per_cell = map_.resolution() / square_, per_metre = kRounding / square_;
  const auto corner = [](double at, int end) { return std::clamp(static_cast<int>(std::floor(at)), 0, end); };
  const int left = corner(u * per_cell - reach_x * per_metre, width_);
  const int right = corner(u * per_cell + reach_x * per_metre + 1.0, width_);
  const int low = corner(v * per_cell - reach_y * per_metre, height_);
  const int high = corner(v * per_cell + reach_y * per_metre + 1.0, height_);
  return sum(right, high) + sum(left, low) != sum(left, high) + sum(right, low);
}

}  // namespace fourwis
