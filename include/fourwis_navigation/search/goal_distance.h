#pragma once

#include <cstdint>
#include <vector>

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// How far C has to travel to the goal at least, obstacles considered and headings not: Dijkstra's algorithm from the
/// goal over cells of about `kCell`, 8-connected, through every cell that holds a point where C may be.
class GoalDistance
{
public:
  /// Computes the field out to `slack` beyond the first path to the start. Where there is none, over all that the goal
  /// reaches.
  GoalDistance(const CollisionChecker& checker, const Pose& start, const Pose& goal, double slack);

  /// Distance to the goal from the cell of a point [m], shortened by what 8-connected paths are too long at most (8.24 %)
  /// and by the size of a cell; infinite where the goal cannot be reached from, and a lower bound beyond the field's edge.
  double operator()(double x, double y) const;

  /// Whether C may get from the start to the goal. False is a proof that it may not.
  bool reaches_start() const { return reaches_start_; }

private:
  std::size_t cell(double x, double y) const;

  const ObstacleMap& map_;
  int factor_;  ///< grid cells to one side of a cell here
  int width_, height_;
  double cell_size_;
  float beyond_;  ///< value where the field was not computed
  bool reaches_start_ = false;
  std::vector<float> field_;
};

}  // namespace fourwis
