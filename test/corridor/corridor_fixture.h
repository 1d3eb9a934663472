#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../support/grids.h"
#include "../support/random.h"
#include "fourwis_navigation/corridor/obstacle_rectangles.h"
#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/vehicle/footprint.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{

/// The obstacles of a grid one by one: the squares of occupied cells and the half-planes beyond the four borders.
class EveryObstacle
{
public:
  explicit EveryObstacle(const OccupancyGrid& grid) : grid_(grid)
  {
    for (int row = 0; row < grid.height; ++row)
      for (int column = 0; column < grid.width; ++column)
        if (ObstacleRule().is_obstacle(grid.at(column, row)))
          cells_.push_back({column * grid.resolution, row * grid.resolution, (column + 1) * grid.resolution,
                            (row + 1) * grid.resolution});
  }

  /// From a point in the map frame to the nearest obstacle [m]; 0 outside the grid.
  double distance(double x, double y) const
  {
    const Pose p = relative_to(grid_.origin, {x, y, 0.0});
    double best = std::max(0.0, std::min({p.x, p.y, width() - p.x, height() - p.y}));
    for (const Box& c : cells_)
      best = std::min(best, std::hypot(std::max({c.x_min - p.x, p.x - c.x_max, 0.0}),
                                       std::max({c.y_min - p.y, p.y - c.y_max, 0.0})));
    return best;
  }

  /// Whether the nearest point of some obstacle, seen along a half-plane's normal, lies `distance` beyond it.
  bool touches(const HalfPlane& plane, double distance, double tolerance) const
  {
    const double c = std::cos(grid_.origin.theta), s = std::sin(grid_.origin.theta);
    const double a = c * plane.a + s * plane.b, b = -s * plane.a + c * plane.b;  // in the grid's frame
    const double offset = plane.c - plane.a * grid_.origin.x - plane.b * grid_.origin.y + distance;
    const auto is_there = [&](double least) { return std::abs(least - offset) <= tolerance; };
    if ((a > 1.0 - 1e-9 && is_there(width())) || (a < -1.0 + 1e-9 && is_there(0.0))) return true;
    if ((b > 1.0 - 1e-9 && is_there(height())) || (b < -1.0 + 1e-9 && is_there(0.0))) return true;
    return std::any_of(cells_.begin(), cells_.end(), [&](const Box& cell) {
      return is_there(a * (a > 0.0 ? cell.x_min : cell.x_max) + b * (b > 0.0 ? cell.y_min : cell.y_max));
    });
  }

private:
  double width() const { return grid_.width * grid_.resolution; }
  double height() const { return grid_.height * grid_.resolution; }

  const OccupancyGrid& grid_;
  std::vector<Box> cells_;
};

/// A grid and what corridors and their tests make of it.
struct Scene
{
  explicit Scene(const OccupancyGrid& grid) : site(grid), obstacles(site.map), every(site.grid) {}

  const Site site;
  const ObstacleRectangles obstacles;
  const EveryObstacle every;
};

/// Centre of a disc at `offset` on the body's x axis.
inline Pose disc_centre(const Pose& pose, const Point2& on_body)
{
  return compose(pose, {on_body.x, on_body.y, 0.0});
}

inline Pose disc_centre(const Pose& pose, double offset)
{
  return compose(pose, {offset, 0.0, 0.0});
}

/// Knots of a drive through free space about `spacing` apart, with cusps and changes of mode, at least two. The map
/// must leave room.
inline std::vector<Pose> random_knots(Random& random, const CollisionChecker& checker, const Robot& robot,
                                      double spacing = 0.2)
{
  std::vector<Pose> knots;
  while (knots.size() < 2)
  {
    knots = {free_pose(random, checker)};
    for (int piece = 0; piece < 6; ++piece)
    {
      const Mode mode = random.mode();
      const double phi = random.steering(robot, mode), step = random.chance(0.3) ? -spacing : spacing;
      for (int k = random.whole(1, 8); k > 0; --k)
      {
        if (!checker.is_free(PathPiece{mode, knots.back(), phi, step})) break;
        knots.push_back(advance(robot, knots.back(), mode, phi, step));
      }
    }
  }
  return knots;
}

/// Maps of both resolutions, straight and turned, with boxes or single cells in the way.
inline OccupancyGrid corridor_grid(Random& random, int k)
{
  const double resolution = k % 2 == 0 ? 0.1 : 0.05;
  const Pose origin = k % 4 < 2 ? Pose{-1.0, 2.0, 0.0} : random.pose(20.0);
  if (k % 3 == 0) return scattered(random, k % 2 == 0 ? 70 : 140, k % 2 == 0 ? 70 : 140, resolution, origin, 0.0015);
  return clutter(random, 7.0, resolution, 8, origin);
}

/// A wall along the lower border of an area of 10 m x 10 m, its upper side at y = 1.
inline OccupancyGrid above_a_wall()
{
  OccupancyGrid grid = free_area(10.0, 10.0, 0.05);
  occupy_block(grid, 0, 0, 200, 20);
  return grid;
}

}  // namespace fourwis
