#pragma once

#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/point.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis::nightly
{

/// The body of any robot, rectangle or polygon, against the squares of the cells around it, by the theorem of separating axes.
/// Keeps a reference to the grid. Shares no code with the planner.
class ExactBody
{
public:
  ExactBody(const OccupancyGrid& grid, const ObstacleRule& rule, const Robot& robot);

  /// Whether the body overlaps an obstacle or leaves the grid by more than a micrometre; the pose is that of C, the centre of the
  /// wheels.
  bool overlaps(const Pose& centre) const;

  /// Of C, where base_link is at a pose.
  Pose centre_of(const Pose& base_link) const;

private:
  bool overlaps_cell(const std::vector<Point2>& corners, double x, double y) const;

  const OccupancyGrid& grid_;
  const ObstacleRule rule_;
  const Pose offset_;            ///< of C in base_link
  std::vector<Point2> corners_;  ///< around C [m]
  mutable std::vector<Point2> placed_;
};

}  // namespace fourwis::nightly
