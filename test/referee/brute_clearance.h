#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

struct Point
{
  double x, y;
};
using Quad = std::array<Point, 4>;

inline Quad rectangle(const Pose& pose, double x0, double x1, double y0, double y1)
{
  Quad quad{{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
  for (Point& p : quad)
  {
    const Pose moved = compose(pose, {p.x, p.y, 0.0});
    p = {moved.x, moved.y};
  }
  return quad;
}

inline Quad body(const Pose& pose, const Robot& robot = {})
{
  return rectangle(pose, -robot.length / 2, robot.length / 2, -robot.width / 2, robot.width / 2);
}

inline Quad square_of(const OccupancyGrid& grid, int column, int row)
{
  const double r = grid.resolution;
  return rectangle(grid.origin, column * r, (column + 1) * r, row * r, (row + 1) * r);
}

/// The greatest gap of the projections on the edge normals. A negative one is the depth of the overlap.
inline double separation(const Quad& a, const Quad& b)
{
  double greatest = -INFINITY;
  for (const Quad* quad : {&a, &b})
    for (std::size_t k = 0; k < 4; ++k)
    {
      const Point p = (*quad)[k], q = (*quad)[(k + 1) % 4];
      const double length = std::hypot(q.x - p.x, q.y - p.y), nx = (q.y - p.y) / length, ny = -(q.x - p.x) / length;
      double a_low = INFINITY, a_high = -INFINITY, b_low = INFINITY, b_high = -INFINITY;
      for (std::size_t i = 0; i < 4; ++i)
      {
        const double along_a = nx * a[i].x + ny * a[i].y, along_b = nx * b[i].x + ny * b[i].y;
        a_low = std::min(a_low, along_a), a_high = std::max(a_high, along_a);
        b_low = std::min(b_low, along_b), b_high = std::max(b_high, along_b);
      }
      greatest = std::max({greatest, b_low - a_high, a_low - b_high});
    }
  return greatest;
}

inline double distance_to_edge(const Point& c, const Point& p, const Point& q)
{
  const double dx = q.x - p.x, dy = q.y - p.y;
  const double share = std::clamp(((c.x - p.x) * dx + (c.y - p.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  return std::hypot(c.x - p.x - share * dx, c.y - p.y - share * dy);
}

/// The distance of two quads. If they overlap, minus the depth.
inline double signed_distance(const Quad& a, const Quad& b)
{
  const double gap = separation(a, b);
  if (gap <= 0.0) return gap;
  double least = INFINITY;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k)
    {
      const std::size_t next = (k + 1) % 4;
      least = std::min({least, distance_to_edge(a[i], b[k], b[next]), distance_to_edge(b[i], a[k], a[next])});
    }
  return least;
}

inline std::vector<Quad> obstacles(const OccupancyGrid& grid, const ObstacleRule& rule)
{
  std::vector<Quad> quads;
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column)
      if (rule.is_obstacle(grid.at(column, row))) quads.push_back(square_of(grid, column, row));
  return quads;
}

/// Least signed distance of the body to all obstacle cells of the grid and to its outside.
inline double brute_clearance(const OccupancyGrid& grid, const std::vector<Quad>& cells, const Pose& pose,
                              const Robot& robot = {})
{
  const Quad quad = body(pose, robot);
  double least = INFINITY;
  for (const Point& p : quad)
  {
    const Pose in_grid = relative_to(grid.origin, {p.x, p.y, 0.0});
    least = std::min({least, in_grid.x, in_grid.y, grid.width * grid.resolution - in_grid.x,
                      grid.height * grid.resolution - in_grid.y});
  }
  const double radius = std::hypot(robot.length, robot.width) / 2 + grid.resolution;
  for (const Quad& other : cells)
    // All other cells are further away than the nearest so far.
    if (distance({other[0].x, other[0].y, 0.0}, pose) - radius - grid.resolution < least)
      least = std::min(least, signed_distance(quad, other));
  return least;
}

}  // namespace fourwis
