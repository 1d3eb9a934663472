#pragma once

#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis::benchmark
{

/// Which poses are joined by motions of the two-disc robot if it could translate and turn freely: a plain flood over a
/// lattice of poses, each checked against all obstacle cells nearby. Slow, and shares nothing with the planner but the
/// paper's eq. (8) to (10).
class BruteForceFlood
{
public:
  /// Keeps a reference to the grid. Its origin must be (0, 0, 0).
  BruteForceFlood(const OccupancyGrid& grid, const ObstacleRule& rule, const Robot& robot);

  /// Whether both discs are clear of obstacles and within the grid.
  bool is_free(const Pose& pose) const;

  /// Whether a chain of free poses of the lattice around `start`, 2.5 cm or 3 degrees apart, ends next to `goal`.
  bool joins(const Pose& start, const Pose& goal) const;

private:
  bool is_free(double x, double y) const;

  const OccupancyGrid& grid_;
  ObstacleRule rule_;
  double offset_;  ///< of the disc centres along the body's x axis [m]
  double radius_;  ///< r_c [m]
};

}  // namespace fourwis::benchmark
