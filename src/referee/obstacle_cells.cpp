#include "obstacle_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "fourwis_navigation/model/sentence.h"

namespace fourwis::referee
{
namespace
{

void check(const OccupancyGrid& grid)
{
  using Error = std::invalid_argument;
  if (grid.width <= 0) reject<Error>("referee: grid width ", grid.width, ", expected > 0");
  if (grid.height <= 0) reject<Error>("referee: grid height ", grid.height, ", expected > 0");
  if (!(grid.resolution > 0.0) || !std::isfinite(grid.resolution))
    reject<Error>("referee: grid resolution ", grid.resolution, " m, expected > 0 and finite");
  if (!is_finite(grid.origin)) reject<Error>("referee: grid origin not finite");
  const std::size_t cells = static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height);
  if (grid.data.size() != cells)
    reject<Error>("referee: grid data size ", grid.data.size(), ", expected width x height = ", cells);
}

std::array<std::uint64_t, 256> obstacle_table(const ObstacleRule& rule)
{
  std::array<std::uint64_t, 256> table;
  for (int value = 0; value < 256; ++value)
    table[static_cast<std::size_t>(value)] = rule.is_obstacle(static_cast<std::int8_t>(value)) ? 1 : 0;
  return table;
}

/// Least u among the points of the box at height dv above its centre, relative to the centre. The left side is convex:
/// two edges that meet in the leftmost corner. The corners bound what rounding can do to a nearly level edge.
struct LeftSide
{
  explicit LeftSide(const Box& box)
    : corner_u(-box.reach_u()),
      corner_v(box.b * box.c - box.a * box.s),
      top_u(box.a * box.c - box.b * box.s),
      upper_slope(box.c / box.s),
      lower_slope(box.s / box.c)
  {}

  double at(double dv) const
  {
    if (dv > corner_v) return std::min(corner_u + (dv - corner_v) * upper_slope, top_u);
    if (dv < corner_v) return std::min(corner_u + (corner_v - dv) * lower_slope, -top_u);
    return corner_u;
  }

  /// Least u among the points of the box between two heights.
  double within(double low, double high) const { return at(std::min(std::max(corner_v, low), high)); }

  double corner_u, corner_v, top_u, upper_slope, lower_slope;
};

double squared(double x)
{
  return x * x;
}

/// Squared distance of a point from a rectangle around the origin, half sides a and b.
double squared_distance(double x, double y, double a, double b)
{
  return squared(std::max(std::abs(x) - a, 0.0)) + squared(std::max(std::abs(y) - b, 0.0));
}

/// Distance of two rectangles that do not overlap. One is the unit square at (du, dv) from the centre of the other. The
/// distance is that of a corner of one of them.
double distance_to_cell(const Box& box, double du, double dv)
{
  double best = INFINITY;
  for (const double su : {-1.0, 1.0})
    for (const double sv : {-1.0, 1.0})
    {
      const double u = du + 0.5 * su, v = dv + 0.5 * sv;
      best = std::min(best, squared_distance(box.c * u + box.s * v, box.c * v - box.s * u, box.a, box.b));
      const double along = su * box.a, across = sv * box.b;
      best = std::min(
          best, squared_distance(box.c * along - box.s * across - du, box.s * along + box.c * across - dv, 0.5, 0.5));
    }
  return std::sqrt(best);
}

}  // namespace

ObstacleCells::ObstacleCells(const OccupancyGrid& grid, const ObstacleRule& rule)
  : width_(grid.width),
    height_(grid.height),
    resolution_(grid.resolution),
    origin_x_(grid.origin.x),
    origin_y_(grid.origin.y),
    origin_cos_(std::cos(grid.origin.theta)),
    origin_sin_(std::sin(grid.origin.theta))
{
  check(grid);
  const auto table = obstacle_table(rule);
  stride_ = (static_cast<std::size_t>(width_) + 63) / 64;
  bits_.resize(stride_ * static_cast<std::size_t>(height_));
  const std::int8_t* cell = grid.data.data();
  std::uint64_t* word = bits_.data();
  for (int row = 0; row < height_; ++row)
    for (int column = 0; column < width_; column += 64, ++word)
    {
      const int count = std::min(64, width_ - column);
      for (int bit = 0; bit < count; ++bit) *word |= table[static_cast<std::uint8_t>(*cell++)] << bit;
    }
}

Box ObstacleCells::box(double x, double y, double cosine, double sine, double half_length, double half_width) const
{
  const double dx = (x - origin_x_) / resolution_, dy = (y - origin_y_) / resolution_;
  Box box{origin_cos_ * dx + origin_sin_ * dy,
          origin_cos_ * dy - origin_sin_ * dx,
          origin_cos_ * cosine + origin_sin_ * sine,
          origin_cos_ * sine - origin_sin_ * cosine,
          half_length / resolution_,
          half_width / resolution_};
  // A rectangle is the same turned by 180 degrees, and by 90 degrees with its sides swapped.
  if (box.c < 0.0) box.c = -box.c, box.s = -box.s;
  if (box.s < 0.0)
  {
    std::swap(box.c, box.s);
    box.c = -box.c;
    std::swap(box.a, box.b);
  }
  return box;
}

bool ObstacleCells::contains(const Box& box) const
{
  const double reach_u = box.reach_u(), reach_v = box.reach_v();
  return box.u - reach_u >= 0.0 && box.u + reach_u <= width_ && box.v - reach_v >= 0.0 && box.v + reach_v <= height_;
}

std::optional<Cell> ObstacleCells::overlapped(const Box& box) const
{
  // Where the box crosses the strip of a row it covers an interval of columns: the strip's part of the box is convex.
  const LeftSide left(box);
  const double reach = box.reach_v();
  const int last = std::min(height_, static_cast<int>(std::ceil(box.v + reach))) - 1;
  for (int row = static_cast<int>(box.v - reach); row <= last; ++row)
  {
    const double low = std::max(row - box.v, -reach), high = std::min(row + 1 - box.v, reach);
    const int from = static_cast<int>(std::max(0.0, box.u + left.within(low, high)));
    const int to = static_cast<int>(std::ceil(box.u - left.within(-high, -low))) - 1;
    const int column = next(row, from, std::min(to, width_ - 1));
    if (column >= 0) return Cell{column, row};
  }
  return std::nullopt;
}

double ObstacleCells::clearance(const Box& box, double cap) const
{
  const LeftSide left(box);
  const double reach_u = box.reach_u(), reach_v = box.reach_v();
  double best = std::min({cap, box.u - reach_u, width_ - box.u - reach_u, box.v - reach_v, height_ - box.v - reach_v});
  best = std::max(best, 0.0);

  const int first = std::clamp(static_cast<int>(box.v - reach_v), 0, height_ - 1);
  const int last = std::clamp(static_cast<int>(std::ceil(box.v + reach_v)) - 1, first, height_ - 1);
  for (int row = first; row <= last; ++row)
  {
    const double low = std::max(row - box.v, -reach_v), high = std::min(row + 1 - box.v, reach_v);
    look_at_row(box, row, static_cast<int>(box.u + left.within(low, high)), best);
  }
  for (int row = last + 1; row < height_ && row - (box.v + reach_v) < best; ++row)
    look_at_row(box, row, static_cast<int>(box.u + left.top_u), best);
  for (int row = first - 1; row >= 0 && (box.v - reach_v) - (row + 1) < best; --row)
    look_at_row(box, row, static_cast<int>(box.u - left.top_u), best);
  return best;
}

/// Along a row the distance of a cell from the box is convex in the column, least at `column`: only the nearest
/// obstacle on either side of it matters.
void ObstacleCells::look_at_row(const Box& box, int row, int column, double& best) const
{
  const double half_cell = 0.5 * (box.c + box.s);  // of the unit square along either axis of the box
  const double dv = row + 0.5 - box.v;
  const auto look_at = [&](int obstacle) {
    const double du = obstacle + 0.5 - box.u;
    const double along = std::abs(box.c * du + box.s * dv) - box.a - half_cell;
    const double across = std::abs(box.c * dv - box.s * du) - box.b - half_cell;
    if (std::max(along, across) < best) best = std::min(best, distance_to_cell(box, du, dv));
  };
  column = std::clamp(column, 0, width_ - 1);
  const int left = previous(row, column, static_cast<int>(std::max(0.0, box.u - box.reach_u() - best - 1.0)));
  if (left >= 0) look_at(left);
  const double rightmost = std::min(width_ - 1.0, box.u + box.reach_u() + best + 1.0);
  const int right = next(row, column, static_cast<int>(rightmost));
  if (right >= 0) look_at(right);
}

int ObstacleCells::next(int row, int from, int to) const
{
  if (from > to) return -1;
  const std::uint64_t* words = bits_.data() + static_cast<std::size_t>(row) * stride_;
  int index = from / 64;
  std::uint64_t word = words[index] & (~std::uint64_t{0} << (from % 64));
  while (word == 0)
  {
    if (++index > to / 64) return -1;
    word = words[index];
  }
  const int column = index * 64 + __builtin_ctzll(word);
  return column <= to ? column : -1;
}

int ObstacleCells::previous(int row, int from, int to) const
{
  if (from < to) return -1;
  const std::uint64_t* words = bits_.data() + static_cast<std::size_t>(row) * stride_;
  int index = from / 64;
  std::uint64_t word = words[index] & (~std::uint64_t{0} >> (63 - from % 64));
  while (word == 0)
  {
    if (--index < to / 64) return -1;
    word = words[index];
  }
  const int column = index * 64 + 63 - __builtin_clzll(word);
  return column >= to ? column : -1;
}

}  // namespace fourwis::referee
