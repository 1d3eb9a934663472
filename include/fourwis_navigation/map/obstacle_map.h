#pragma once

#include <cstdint>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// Exact Euclidean distance to the obstacles of a grid. Obstacles are closed squares (the whole cell, not its centre) and
/// everything outside the grid.
class ObstacleMap
{
public:
  /// Throws std::invalid_argument naming the field when grid or rule are unusable: see check_grid() and check().
  explicit ObstacleMap(const OccupancyGrid& grid, const ObstacleRule& rule = {});

  /// Distance from a point in the map frame to the nearest obstacle [m]; 0 inside one and outside the grid.
  double distance(double x, double y) const;

  /// Whether distance(x, y) >= radius, faster.
  bool is_clear(double x, double y, double radius) const;

  /// The same; if so, also lowers `clearance` to a lower bound of distance(x, y) - radius where that is smaller.
  bool is_clear(double x, double y, double radius, double& clearance) const;

  int width() const { return width_; }
  int height() const { return height_; }
  double resolution() const { return resolution_; }
  const Pose& origin() const { return origin_; }

  /// Least distance between any point of the cell and any obstacle [m]. The cell must lie in the grid.
  double cell_distance(int column, int row) const { return field_[index(column, row)]; }

  /// First column of an obstacle in a row, looking from `column` on; width() when there is none. The row must lie in the
  /// grid, and the column must not be negative.
  int next_obstacle(int column, int row) const;

  /// Whether none of the cells from `first` to `last` of a row is an obstacle. They must lie in the grid.
  bool is_free_row(int first, int last, int row) const
  {
    const RowNeighbours* cells = neighbours_.data() + index(0, row);
    // Distances are cut at what a RowNeighbours holds, so a look may end on the way.
    for (int column = first; column <= last; column += cells[column].right)
      if (cells[column].right == 0) return false;
    return true;
  }

  /// Position in cells of a point in the map frame: (0, 0) is the origin, (1, 1) the far corner of cell (0, 0).
  void to_cells(double x, double y, double& column, double& row) const;

private:
  std::size_t index(int column, int row) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
  }

  /// Cells to the nearest obstacle of the same row on either side; 0 on an obstacle.
  struct RowNeighbours
  {
    std::uint16_t left, right;
  };

  /// Distance in cells from (u, v), no more than `limit`; below `enough`, any upper bound of it.
  double exact_cells(double u, double v, double limit, double enough) const;

  int width_, height_;
  double resolution_;
  Pose origin_;
  double cos_, sin_;
  double slack_;  ///< how much further than field_ says a point may be from the obstacles: a cell's diagonal [m]
  std::vector<float> field_;  ///< square to square, rounded down [m]
  std::vector<RowNeighbours> neighbours_;
};

/// Throws std::invalid_argument naming field, value and what was expected when a grid is unusable: no cells, data size not
/// width x height, resolution not from 1e-9 to 1e9 m, origin not finite or beyond 1e12.
void check_grid(const OccupancyGrid& grid);

}  // namespace fourwis
