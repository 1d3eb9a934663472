#pragma once

#include <cstdint>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis::nightly
{

/// Which poses are joined by motions of a rectangle that can translate and turn freely: the components of a lattice of
/// poses, 25 mm and 3 degrees apart, at which the rectangle overlaps no obstacle cell and lies within the grid. Shares no
/// code with the planner.
class RectangleFlood
{
public:
  /// The rectangle is the robot's body with `margin` on each side [m]. Only the grid's own frame counts, not its origin.
  RectangleFlood(const OccupancyGrid& grid, const ObstacleRule& rule, const Robot& robot, double margin);

  /// How far a point of the body is at most from where it is at the nearer of two neighbours of the lattice, at any pose
  /// between them [m]. Where poses are joined with a margin m, there is a motion of the body that keeps m less this.
  static double half_step(const Robot& robot);

  /// The pose of the lattice nearest to one within the grid.
  Pose nearest(const Pose& pose) const;

  /// Whether two poses, rounded to the lattice, are clear and joined.
  bool joins(const Pose& start, const Pose& goal) const;

private:
  struct Place
  {
    std::size_t column, row, heading;
  };
  struct Shape;

  std::size_t index(const Place& place) const { return (place.heading * rows_ + place.row) * columns_ + place.column; }
  Place place(const Pose& pose) const;

  void block_border(const Shape& shape, std::size_t heading);
  void block_cell(const Shape& shape, std::size_t heading, double x, double y);
  void turn_half();
  void label_components();
  void fill(const Place& from, std::int32_t label);

  std::size_t columns_, rows_;
  double width_, height_;                ///< of the grid [m]
  std::vector<std::int32_t> component_;  ///< of each place: -1 blocked, 0 not seen yet, or a number
};

}  // namespace fourwis::nightly
