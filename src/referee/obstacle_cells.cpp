#include "obstacle_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

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

double squared(double x)
{
  return x * x;
}

/// Squared distance of a point from the segment between two others.
double squared_distance(const Point2& p, const Point2& from, const Point2& to)
{
  const double dx = to.x - from.x, dy = to.y - from.y, length = squared(dx) + squared(dy);
  const double along = (p.x - from.x) * dx + (p.y - from.y) * dy;
  const double share = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
  return squared(p.x - from.x - share * dx) + squared(p.y - from.y - share * dy);
}

/// Distance of a polygon from the unit square around (u, v), which it does not overlap. It is that of a corner of one of them.
double distance_to_cell(const Outline& outline, double u, double v)
{
  double best = INFINITY;
  const std::size_t count = outline.corners.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point2 &corner = outline.corners[i], &next = outline.corners[i + 1 == count ? 0 : i + 1];
    best = std::min(best, squared(std::max(std::abs(corner.x - u) - 0.5, 0.0)) +
                              squared(std::max(std::abs(corner.y - v) - 0.5, 0.0)));
    for (const double su : {-0.5, 0.5})
      for (const double sv : {-0.5, 0.5}) best = std::min(best, squared_distance({u + su, v + sv}, corner, next));
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

void Outline::columns_between(double low, double high, double& least, double& greatest) const
{
  least = INFINITY;
  greatest = -INFINITY;
  const auto add = [&](double u) {
    least = std::min(least, u);
    greatest = std::max(greatest, u);
  };
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Point2 &from = corners[i], &to = corners[i + 1 == corners.size() ? 0 : i + 1];
    if (from.y >= low && from.y <= high) add(from.x);
    // Between the corners, whatever rounding does to a nearly level side.
    for (const double line : {low, high})
      if ((from.y < line) != (to.y < line))
        add(from.x + std::clamp((line - from.y) / (to.y - from.y), 0.0, 1.0) * (to.x - from.x));
  }
}

void ObstacleCells::place(const Shape& shape, double x, double y, double cosine, double sine, Outline& outline) const
{
  const double dx = (x - origin_x_) / resolution_, dy = (y - origin_y_) / resolution_;
  const double u = origin_cos_ * dx + origin_sin_ * dy, v = origin_cos_ * dy - origin_sin_ * dx;
  const double c = origin_cos_ * cosine + origin_sin_ * sine, s = origin_cos_ * sine - origin_sin_ * cosine;
  const std::size_t count = shape.corners.size();
  outline.corners.resize(count);
  outline.normals.resize(count);
  outline.left = outline.bottom = INFINITY;
  outline.right = outline.top = -INFINITY;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point2 &p = shape.corners[i], &n = shape.normals[i];
    const Point2 corner = {u + (c * p.x - s * p.y) / resolution_, v + (s * p.x + c * p.y) / resolution_};
    outline.corners[i] = corner;
    outline.normals[i] = {c * n.x - s * n.y, s * n.x + c * n.y};
    outline.left = std::min(outline.left, corner.x);
    outline.right = std::max(outline.right, corner.x);
    if (corner.y < outline.bottom) outline.bottom = corner.y, outline.bottom_u = corner.x;
    if (corner.y > outline.top) outline.top = corner.y, outline.top_u = corner.x;
  }
}

bool ObstacleCells::contains(const Outline& outline) const
{
  return outline.left >= 0.0 && outline.right <= width_ && outline.bottom >= 0.0 && outline.top <= height_;
}

std::optional<Cell> ObstacleCells::overlapped(const Outline& outline) const
{
  // Where the outline crosses the strip of a row it covers an interval of columns: the strip's part of it is convex.
  const int last = std::min(height_, static_cast<int>(std::ceil(outline.top))) - 1;
  for (int row = static_cast<int>(outline.bottom); row <= last; ++row)
  {
    double least, greatest;
    outline.columns_between(row, row + 1.0, least, greatest);
    const int from = static_cast<int>(std::max(0.0, least));
    const int to = static_cast<int>(std::ceil(greatest)) - 1;
    const int column = next(row, from, std::min(to, width_ - 1));
    if (column >= 0) return Cell{column, row};
  }
  return std::nullopt;
}

double ObstacleCells::clearance(const Outline& outline, double cap) const
{
  double best = std::min({cap, outline.left, width_ - outline.right, outline.bottom, height_ - outline.top});
  best = std::max(best, 0.0);

  const int first = std::clamp(static_cast<int>(outline.bottom), 0, height_ - 1);
  const int last = std::clamp(static_cast<int>(std::ceil(outline.top)) - 1, first, height_ - 1);
  for (int row = first; row <= last; ++row)
  {
    double least, greatest;
    outline.columns_between(row, row + 1.0, least, greatest);
    look_at_row(outline, row, static_cast<int>(std::clamp(least, 0.0, width_ - 1.0)), best);
  }
  for (int row = last + 1; row < height_ && row - outline.top < best; ++row)
    look_at_row(outline, row, static_cast<int>(outline.top_u), best);
  for (int row = first - 1; row >= 0 && outline.bottom - (row + 1) < best; --row)
    look_at_row(outline, row, static_cast<int>(outline.bottom_u), best);
  return best;
}

/// Along a row the distance of a cell from the outline is convex in the column, least at `column`: only the nearest
/// obstacle on either side of it matters.
void ObstacleCells::look_at_row(const Outline& outline, int row, int column, double& best) const
{
  const double v = row + 0.5;
  const auto look_at = [&](int obstacle) {
    const double u = obstacle + 0.5;
    // The distance is at least that from each of the outline's sides.
    double least = 0.0;
    for (std::size_t i = 0; i < outline.corners.size(); ++i)
    {
      const Point2 &corner = outline.corners[i], &n = outline.normals[i];
      least = std::max(least, n.x * (u - corner.x) + n.y * (v - corner.y) - 0.5 * (std::abs(n.x) + std::abs(n.y)));
    }
    if (least < best) best = std::min(best, distance_to_cell(outline, u, v));
  };
  column = std::clamp(column, 0, width_ - 1);
  const int left = previous(row, column, static_cast<int>(std::max(0.0, outline.left - best - 1.0)));
  if (left >= 0) look_at(left);
  const int right = next(row, column, static_cast<int>(std::min(width_ - 1.0, outline.right + best + 1.0)));
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
