#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/search/search_problem.h"

namespace fourwis
{

/// Square cells of any size that cover a map.
class CoarseCells
{
public:
  CoarseCells(const ObstacleMap& map, double size);

  int width() const { return width_; }
  int height() const { return height_; }
  double size() const { return size_; }  ///< side of a cell [m]
  std::size_t count() const { return static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_); }

  /// Index of the cell a point of the map frame lies in; points outside belong to the nearest cell.
  int index(double x, double y) const;

  /// Centre of a cell in the map frame.
  Pose centre(int index) const;

  /// Calls visit(cell) for a cell and those up to `reach` rows and columns away.
  template <typename Visit>
  void for_square(int index, int reach, Visit visit) const
  {
    const int column = index % width_, row = index / width_;
    for (int j = std::max(0, row - reach); j <= std::min(height_ - 1, row + reach); ++j)
      for (int i = std::max(0, column - reach); i <= std::min(width_ - 1, column + reach); ++i) visit(j * width_ + i);
  }

  /// Calls visit(neighbour, is_diagonal) for the up to eight neighbours of a cell.
  template <typename Visit>
  void for_neighbours(int index, Visit visit) const
  {
    const int column = index % width_, row = index / width_;
    for (int dj = -1; dj <= 1; ++dj)
      for (int di = -1; di <= 1; ++di)
      {
        const int i = column + di, j = row + dj;
        if ((di != 0 || dj != 0) && i >= 0 && j >= 0 && i < width_ && j < height_)
          visit(j * width_ + i, di != 0 && dj != 0);
      }
  }

private:
  const ObstacleMap& map_;
  double size_;
  double per_map_cell_;  ///< cells to a side of a map cell
  int width_, height_;
};

/// A lower bound of the distance that C, the centre of the wheels, has to travel to the goal. It considers obstacles,
/// but no headings. Dijkstra's algorithm from the goal over coarse 8-connected cells, through every cell that may hold
/// a point where C can be.
class GoalDistance
{
public:
  /// Computes the field up to `slack` metres beyond the first path to the start. If there is no path, the field covers
  /// everything that can be reached from the goal. If interrupted it stops early, and the field is not usable.
  GoalDistance(const SearchProblem& problem, double slack);

  /// Distance to the goal from the cell of a point [m]. It is shortened by the greatest excess of 8-connected paths
  /// (8.24 %) and by the size of a cell. It is infinite where there is no way to the goal, and a lower bound beyond the
  /// edge of the field.
  double operator()(double x, double y) const { return field_[static_cast<std::size_t>(cells_.index(x, y))]; }

  /// Whether C may get from the start to the goal. False is a proof that it cannot.
  bool reaches_start() const { return reaches_start_; }

  const CoarseCells& cells() const { return cells_; }

private:
  bool is_passable(const CollisionChecker& checker, int cell) const;

  CoarseCells cells_;
  bool reaches_start_ = false;
  std::vector<float> field_;
};

}  // namespace fourwis
