#pragma once

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

/// How far C has to travel to the goal at least, obstacles considered and headings not: Dijkstra's algorithm from the
/// goal over coarse cells, 8-connected, through every cell that may hold a point where C can be.
class GoalDistance
{
public:
  /// Computes the field out to `slack` metres beyond the first path to the start; where there is none, over all that the
  /// goal reaches. Stops early, with a field of no use, when interrupted.
  GoalDistance(const SearchProblem& problem, double slack);

  /// Distance to the goal from the cell of a point [m], shortened by what 8-connected paths are too long at most (8.24 %)
  /// and by the size of a cell; infinite where there is no way to the goal, and a lower bound beyond the field's edge.
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
