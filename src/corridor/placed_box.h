#pragma once

#include <array>

#include "fourwis_navigation/corridor/obstacle_rectangles.h"

namespace fourwis
{

/// A box of the map frame among the obstacles of a grid that may be turned.
class PlacedBox
{
public:
  PlacedBox(const ObstacleRectangles& obstacles, const Box& box);

  /// Whether no obstacle is nearer than `radius`.
  bool is_clear(double radius) const;

  /// Square of the distance to a rectangle of the grid's frame [m^2].
  double squared_distance(const Box& obstacle) const;

private:
  const ObstacleRectangles& obstacles_;
  Box box_;                        ///< map frame
  std::array<Point2, 4> corners_;  ///< grid's frame
  Box bounds_;                     ///< of the corners
};

}  // namespace fourwis
