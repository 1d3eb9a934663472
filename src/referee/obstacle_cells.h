#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/point.h"
#include "shape.h"

namespace fourwis::referee
{

/// A convex polygon at a pose, in the grid's frame, in cells. It can be used again without asking for memory.
struct Outline
{
  std::vector<Point2> corners;  ///< counter-clockwise
  std::vector<Point2> normals;  ///< of the side from each corner to the next, outward, of length one
  double left, right, bottom, top;
  double bottom_u, top_u;  ///< where it is lowest and highest

  /// Least and greatest u of the part with v in [low, high], which must not be empty.
  void columns_between(double low, double high, double& least, double& greatest) const;
};

struct Cell
{
  int column = 0, row = 0;
};

/// The obstacles of a grid as rows of bits, for exact questions about convex polygons. All lengths in cells.
class ObstacleCells
{
public:
  /// Throws std::invalid_argument naming field, value and what was expected when the grid is unusable.
  ObstacleCells(const OccupancyGrid& grid, const ObstacleRule& rule);

  double resolution() const { return resolution_; }  ///< side of a cell [m]

  /// A body with C at (x, y) in the map frame, heading (cosine, sine). The shape must not be empty.
  void place(const Shape& shape, double x, double y, double cosine, double sine, Outline& outline) const;

  /// Whether the outline lies in the grid; touching the border is inside.
  bool contains(const Outline& outline) const;

  /// An obstacle cell whose interior meets the interior of the outline, if there is one. The outline lies in the grid.
  std::optional<Cell> overlapped(const Outline& outline) const;

  /// Distance from the outline to the nearest obstacle or the border, `cap` when that is less. The outline lies in the grid and
  /// overlaps no obstacle.
  double clearance(const Outline& outline, double cap) const;

private:
  int next(int row, int from, int to) const;      ///< first obstacle column in [from, to], -1: none
  int previous(int row, int from, int to) const;  ///< last obstacle column in [to, from], -1: none
  void look_at_row(const Outline& outline, int row, int column, double& best) const;

  int width_, height_;
  double resolution_;
  double origin_x_, origin_y_, origin_cos_, origin_sin_;
  std::size_t stride_;               ///< words of a row
  std::vector<std::uint64_t> bits_;  ///< bit c % 64 of word c / 64 of a row: cell in column c is an obstacle
};

}  // namespace fourwis::referee
