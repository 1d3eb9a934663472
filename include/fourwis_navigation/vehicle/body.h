#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "fourwis_navigation/model/point.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// A convex polygon in the frame of C, the centre of the wheels: its corners counter-clockwise [m].
using ConvexPolygon = std::vector<Point2>;

/// The robot's body, seen from above.
ConvexPolygon body_of(const Robot& robot);

/// The rectangle along the axes that the body fills, in the frame of C [m].
struct BodyBox
{
  double length, width;
  Point2 middle;
};
BodyBox box_of(const Robot& robot);

/// The polygon with each side moved outward by `margin` [m], inward where that is negative. Empty where nothing is left.
ConvexPolygon grown(const ConvexPolygon& polygon, double margin);

/// Least and greatest x of what lies between two heights [m, or whatever the corners are in]; the least is greater where there
/// is nothing.
struct Extent
{
  double least = std::numeric_limits<double>::infinity(), greatest = -std::numeric_limits<double>::infinity();

  void add(double x)
  {
    least = std::min(least, x);
    greatest = std::max(greatest, x);
  }
};

/// Of the part of a convex polygon of `count` corners with y from `bottom` to `top`.
Extent extent_between(const Point2* corners, std::size_t count, double bottom, double top);

/// Distance of the farthest corner from C [m].
double reach_of(const ConvexPolygon& polygon);

/// Radius of the largest disc around C within the polygon [m]; 0 if C lies outside.
double inner_radius_of(const ConvexPolygon& polygon);

}  // namespace fourwis
