#pragma once

#include <cstddef>
#include <vector>

#include "fourwis_navigation/corridor/obstacle_rectangles.h"

namespace fourwis
{

/// A convex polygon that is cut by half-planes.
class Polygon
{
public:
  /// Begins as a square around a point.
  Polygon(const Point2& centre, double half_side);

  /// Keeps what lies in the half-plane. Its new side is remembered as number `name`.
  void cut(const HalfPlane& plane, int name);

  /// Whether a side of that number is left.
  bool has_side(int name) const;

  std::vector<Point2> corners() const;

private:
  struct Corner
  {
    Point2 at;
    int side;  ///< number of the side that begins here, -1 for those of the square
  };

  std::vector<Corner> corners_, next_;
};

}  // namespace fourwis
