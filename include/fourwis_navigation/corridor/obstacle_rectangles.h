#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "fourwis_navigation/map/obstacle_map.h"
#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/model/point.h"
#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// The obstacles of a map as few rectangles, so that what lies near a place is found quickly.
///
/// Coordinates are metres in the grid's frame: x along its rows, y along its columns, from the grid's origin.
/// Rectangles are closed and, together, are exactly the obstacles.
class ObstacleRectangles
{
public:
  /// Keeps no reference to the map.
  explicit ObstacleRectangles(const ObstacleMap& map);

  /// Whether `predicate` holds for any obstacle in `window`. Obstacles are cut to the window before. Where the window
  /// leaves the grid, the outside is an obstacle as well. The window must be finite.
  template <typename Predicate>
  bool any_of(const Box& window, Predicate predicate) const;

  /// Whether a point lies in the grid. False if it is not finite.
  bool contains(const Point2& p) const { return p.x >= 0.0 && p.y >= 0.0 && p.x <= width_ && p.y <= height_; }

  /// Into the grid's frame, and back.
  Point2 to_grid(double x, double y) const;
  Point2 to_map(const Point2& point) const;
  HalfPlane to_map(const HalfPlane& plane) const;

  /// The obstacles' rectangles, disjoint, without the outside.
  const std::vector<Box>& rectangles() const { return rectangles_; }

private:
  /// Rectangles do not cross the borders of square tiles.
  struct Tiles
  {
    double side;  ///< [m]
    int columns, rows;

    int column_at(double x) const { return at(x, columns); }
    int row_at(double y) const { return at(y, rows); }

  private:
    int at(double position, int count) const
    {
      return static_cast<int>(std::clamp(position / side, 0.0, static_cast<double>(count - 1)));
    }
  };

  void append_tile(const ObstacleMap& map, int first_column, int first_row);

  Pose origin_;
  double cos_, sin_;
  double width_, height_;
  Tiles tiles_;
  std::vector<Box> rectangles_;             ///< tile after tile
  std::vector<std::size_t> first_in_tile_;  ///< and one past the last
};

template <typename Predicate>
bool ObstacleRectangles::any_of(const Box& window, Predicate predicate) const
{
  const auto holds = [&](const Box& obstacle) {
    const Box part{std::max(obstacle.x_min, window.x_min), std::max(obstacle.y_min, window.y_min),
                   std::min(obstacle.x_max, window.x_max), std::min(obstacle.y_max, window.y_max)};
    return part.x_min < part.x_max && part.y_min < part.y_max && predicate(part);
  };
  if (window.x_min < 0.0 && holds({window.x_min, window.y_min, 0.0, window.y_max})) return true;
  if (window.y_min < 0.0 && holds({window.x_min, window.y_min, window.x_max, 0.0})) return true;
  if (window.x_max > width_ && holds({width_, window.y_min, window.x_max, window.y_max})) return true;
  if (window.y_max > height_ && holds({window.x_min, height_, window.x_max, window.y_max})) return true;

  for (int row = tiles_.row_at(window.y_min); row <= tiles_.row_at(window.y_max); ++row)
  {
    const std::size_t before = static_cast<std::size_t>(row) * static_cast<std::size_t>(tiles_.columns);
    const std::size_t first = before + static_cast<std::size_t>(tiles_.column_at(window.x_min));
    const std::size_t last = before + static_cast<std::size_t>(tiles_.column_at(window.x_max));
    for (std::size_t i = first_in_tile_[first]; i < first_in_tile_[last + 1]; ++i)
      if (holds(rectangles_[i])) return true;
  }
  return false;
}

}  // namespace fourwis
