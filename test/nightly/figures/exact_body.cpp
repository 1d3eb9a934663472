#include "exact_body.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fourwis::nightly
{
namespace
{

constexpr double kTouch = 1e-6;  ///< less overlap than this is none [m]

struct Range
{
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  void add(double value)
  {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

int cell_at(double value, double resolution, int count)
{
  return std::clamp(static_cast<int>(std::floor(value / resolution)), 0, count - 1);
}

}  // namespace

ExactBody::ExactBody(const OccupancyGrid& grid, const ObstacleRule& rule, const Robot& robot)
  : grid_(grid),
    rule_(rule),
    offset_{robot.base_offset.x, robot.base_offset.y, 0.0}
{
  for (const Point2& corner : robot.footprint)
    corners_.push_back({corner.x - robot.base_offset.x, corner.y - robot.base_offset.y});
  if (!corners_.empty()) return;
  for (const auto& [i, j] : {std::array{1, 1}, {-1, 1}, {-1, -1}, {1, -1}})
    corners_.push_back({robot.body_offset.x + i * robot.length / 2.0, robot.body_offset.y + j * robot.width / 2.0});
}

Pose ExactBody::centre_of(const Pose& base_link) const
{
  return compose(base_link, offset_);
}

bool ExactBody::overlaps(const Pose& centre) const
{
  const Pose pose = relative_to(grid_.origin, centre);
  const double c = std::cos(pose.theta), s = std::sin(pose.theta), r = grid_.resolution;
  placed_.clear();
  Range x, y;
  for (const Point2& corner : corners_)
  {
    placed_.push_back({pose.x + c * corner.x - s * corner.y, pose.y + s * corner.x + c * corner.y});
    x.add(placed_.back().x);
    y.add(placed_.back().y);
  }
  // A pose that is not a number is nowhere.
  if (!(std::min(x.low, y.low) >= -kTouch && x.high <= grid_.width * r + kTouch && y.high <= grid_.height * r + kTouch))
    return true;
  const int right = cell_at(x.high, r, grid_.width), top = cell_at(y.high, r, grid_.height);
  for (int row = cell_at(y.low, r, grid_.height); row <= top; ++row)
    for (int column = cell_at(x.low, r, grid_.width); column <= right; ++column)
      if (rule_.is_obstacle(grid_.at(column, row)) && overlaps_cell(placed_, column * r, row * r)) return true;
  return false;
}

/// The cell's lower left corner is at (x, y).
bool ExactBody::overlaps_cell(const std::vector<Point2>& corners, double x, double y) const
{
  const double r = grid_.resolution;
  Range along_x, along_y;
  for (const Point2& corner : corners)
  {
    along_x.add(corner.x);
    along_y.add(corner.y);
  }
  if (std::min(along_x.high - x, x + r - along_x.low) <= kTouch) return false;
  if (std::min(along_y.high - y, y + r - along_y.low) <= kTouch) return false;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Point2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double length = std::hypot(b.x - a.x, b.y - a.y), nx = (b.y - a.y) / length, ny = (a.x - b.x) / length;
    Range body, cell;
    for (const Point2& corner : corners) body.add(nx * corner.x + ny * corner.y);
    for (const auto& [i_x, i_y] : {std::array{0, 0}, {1, 0}, {0, 1}, {1, 1}})
      cell.add(nx * (x + i_x * r) + ny * (y + i_y * r));
    if (std::min(body.high - cell.low, cell.high - body.low) <= kTouch) return false;
  }
  return true;
}

}  // namespace fourwis::nightly
