#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/point.h"
#include "fourwis_navigation/model/robot.h"
#include "random.h"

namespace fourwis
{

/// The least distance by which one convex polygon has to be moved to overlap the other no more, along the normals of their sides
/// [m]; negative where one of these separates them.
inline double overlap_depth(const std::vector<Point2>& p, const std::vector<Point2>& q)
{
  double least = INFINITY;
  for (const auto* polygon : {&p, &q})
    for (std::size_t i = 0; i < polygon->size(); ++i)
    {
      const Point2 &a = (*polygon)[i], &b = (*polygon)[(i + 1) % polygon->size()];
      const double length = std::hypot(b.x - a.x, b.y - a.y), nx = (b.y - a.y) / length, ny = (a.x - b.x) / length;
      double p_low = INFINITY, p_high = -INFINITY, q_low = INFINITY, q_high = -INFINITY;
      for (const Point2& c : p)
        p_low = std::min(p_low, nx * c.x + ny * c.y), p_high = std::max(p_high, nx * c.x + ny * c.y);
      for (const Point2& c : q)
        q_low = std::min(q_low, nx * c.x + ny * c.y), q_high = std::max(q_high, nx * c.x + ny * c.y);
      least = std::min({least, p_high - q_low, q_high - p_low});
    }
  return least;
}

/// The body of a robot as a polygon around base_link, against the square of each occupied cell: by separating axes.
class ExactPolygon
{
public:
  ExactPolygon(const OccupancyGrid& grid, const Robot& robot) : grid_(grid), corners_(robot.footprint)
  {
    if (!corners_.empty()) return;
    const double x = robot.base_offset.x + robot.body_offset.x, y = robot.base_offset.y + robot.body_offset.y;
    for (const auto& [i, j] : {std::array{1, 1}, {-1, 1}, {-1, -1}, {1, -1}})
      corners_.push_back({x + i * robot.length / 2.0, y + j * robot.width / 2.0});
  }

  /// The least distance by which the polygon has to be moved to overlap nothing, along the best axis for each cell, or by which
  /// it leaves the grid [m]; 0 where it is clear. `base_link` is in the frame of the grid's map.
  double overlap(const Pose& base_link) const
  {
    const Pose pose = relative_to(grid_.origin, base_link);
    std::vector<Point2> body;
    for (const Point2& corner : corners_)
    {
      const Pose placed = compose(pose, {corner.x, corner.y, 0.0});
      body.push_back({placed.x, placed.y});
    }
    const double right = grid_.width * grid_.resolution, top = grid_.height * grid_.resolution;
    double most = 0.0;
    double low_x = INFINITY, low_y = INFINITY, high_x = -INFINITY, high_y = -INFINITY;
    for (const Point2& p : body)
    {
      most = std::max({most, -p.x, -p.y, p.x - right, p.y - top});
      low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
      low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
    }
    const double r = grid_.resolution;
    const auto cell_of = [&](double x, int limit) {
      return std::clamp(static_cast<int>(std::floor(x / r)), 0, limit - 1);
    };
    for (int row = cell_of(low_y, grid_.height); row <= cell_of(high_y, grid_.height); ++row)
      for (int column = cell_of(low_x, grid_.width); column <= cell_of(high_x, grid_.width); ++column)
        if (grid_.at(column, row) > 64 || grid_.at(column, row) < 0)
          most = std::max(most, overlap_depth(body, {{column * r, row * r},
                                                     {(column + 1) * r, row * r},
                                                     {(column + 1) * r, (row + 1) * r},
                                                     {column * r, (row + 1) * r}}));
    return most;
  }

  bool collides(const Pose& base_link) const { return overlap(base_link) > 1e-9; }

private:
  const OccupancyGrid& grid_;
  std::vector<Point2> corners_;  ///< in base_link
};

/// A robot with a convex footprint of 4 to 10 corners around its wheels, and base_link anywhere near.
inline Robot polygon_robot(Random& random)
{
  Robot robot;
  robot.base_offset = {random.between(-0.6, 0.6), random.between(-0.3, 0.3)};
  const double wheels = std::hypot(robot.wheelbase, robot.track_width) / 2.0;
  // Tangents of a circle around the wheels, then some of the corners that they make.
  const int sides = random.whole(4, 10);
  const double turn = random.angle(), radius = wheels + random.between(0.01, 0.1);
  const double nose = random.between(0.0, 0.4);
  for (int k = 0; k < sides; ++k)
  {
    const double angle = turn + 2.0 * M_PI * k / sides, reach = radius / std::cos(M_PI / sides);
    const double x = reach * std::cos(angle), y = reach * std::sin(angle);
    robot.footprint.push_back({robot.base_offset.x + x * (x > 0.0 ? 1.0 + nose : 1.0), robot.base_offset.y + y});
  }
  if (random.chance(0.5)) std::reverse(robot.footprint.begin(), robot.footprint.end());
  return robot;
}

}  // namespace fourwis
