#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"

namespace fourwis::referee
{

/// A rectangle in the grid's frame, in cells: centre (u, v), unit vector (c, s) of one axis with c, s >= 0, half the
/// side along it (a) and across it (b). With c, s >= 0 its leftmost corner is -a e + b n and its topmost a e + b n.
struct Box
{
  double u, v;
  double c, s;
  double a, b;

  double reach_u() const { return a * c + b * s; }  ///< half its extent along u
  double reach_v() const { return a * s + b * c; }  ///< half its extent along v
};

struct Cell
{
  int column = 0, row = 0;
};

/// The obstacles of a grid as rows of bits, for exact questions about rectangles. All lengths in cells.
class ObstacleCells
{
public:
  /// Throws std::invalid_argument naming field, value and what was expected when the grid is unusable.
  ObstacleCells(const OccupancyGrid& grid, const ObstacleRule& rule);

  double resolution() const { return resolution_; }  ///< side of a cell [m]

  /// The rectangle of a body at (x, y) in the map frame, heading (cosine, sine), half sides in metres.
  Box box(double x, double y, double cosine, double sine, double half_length, double half_width) const;

  /// Whether the box lies in the grid; touching the border is inside.
  bool contains(const Box& box) const;

  /// An obstacle cell whose interior meets the interior of the box, if there is one. The box lies in the grid.
  std::optional<Cell> overlapped(const Box& box) const;

  /// Distance from the box to the nearest obstacle or the border, `cap` when that is less. The box lies in the grid and
  /// overlaps no obstacle.
  double clearance(const Box& box, double cap) const;

private:
  int next(int row, int from, int to) const;      ///< first obstacle column in [from, to], -1: none
  int previous(int row, int from, int to) const;  ///< last obstacle column in [to, from], -1: none
  void look_at_row(const Box& box, int row, int column, double& best) const;

  int width_, height_;
  double resolution_;
  double origin_x_, origin_y_, origin_cos_, origin_sin_;
  std::size_t stride_;               ///< words of a row
  std::vector<std::uint64_t> bits_;  ///< bit c % 64 of word c / 64 of a row: cell in column c is an obstacle
};

}  // namespace fourwis::referee
