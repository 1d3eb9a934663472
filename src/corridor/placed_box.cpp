#include "placed_box.h"

#include <algorithm>
#include <cmath>

#include "closest_points.h"

namespace fourwis
{
namespace
{

/// Distances are kept with this tolerance [m].
constexpr double kRounding = 1e-10;

using Corners = std::array<Point2, 4>;

Corners corners_of(const Box& box)
{
  return {{{box.x_min, box.y_min}, {box.x_max, box.y_min}, {box.x_max, box.y_max}, {box.x_min, box.y_max}}};
}

Box bounds_of(const Corners& corners)
{
  const auto x = std::minmax({corners[0].x, corners[1].x, corners[2].x, corners[3].x});
  const auto y = std::minmax({corners[0].y, corners[1].y, corners[2].y, corners[3].y});
  return {x.first, y.first, x.second, y.second};
}

double squared_gap(const Box& a, const Box& b)
{
  const double dx = std::max({a.x_min - b.x_max, b.x_min - a.x_max, 0.0});
  const double dy = std::max({a.y_min - b.y_max, b.y_min - a.y_max, 0.0});
  return dx * dx + dy * dy;
}

/// From the nearest of some points to a box.
double squared_gap(const Corners& points, const Box& box)
{
  double best = INFINITY;
  for (const Point2& point : points)
  {
    const Point2 on_box = nearest(box, point);
    const double dx = point.x - on_box.x, dy = point.y - on_box.y;
    best = std::min(best, dx * dx + dy * dy);
  }
  return best;
}

}  // namespace

PlacedBox::PlacedBox(const ObstacleRectangles& obstacles, const Box& box)
  : obstacles_(obstacles),
    box_(box),
    corners_(corners_of(box))
{
  for (Point2& corner : corners_) corner = obstacles.to_grid(corner.x, corner.y);
  bounds_ = bounds_of(corners_);
}

/// The axes of the two frames may be separating axes. If none of them separates, the shapes meet. Otherwise a corner of
/// one shape is nearest to the other.
double PlacedBox::squared_distance(const Box& obstacle) const
{
  Corners corners = corners_of(obstacle);
  for (Point2& corner : corners) corner = obstacles_.to_map(corner);
  if (squared_gap(bounds_, obstacle) == 0.0 && squared_gap(box_, bounds_of(corners)) == 0.0) return 0.0;
  return std::min(squared_gap(corners_, obstacle), squared_gap(corners, box_));
}

bool PlacedBox::is_clear(double radius) const
{
  const double enough = (radius - kRounding) * (radius - kRounding);
  const Box window{bounds_.x_min - radius, bounds_.y_min - radius, bounds_.x_max + radius, bounds_.y_max + radius};
  return !obstacles_.any_of(window, [&](const Box& obstacle) {
    return squared_gap(bounds_, obstacle) < enough && squared_distance(obstacle) < enough;
  });
}

}  // namespace fourwis
