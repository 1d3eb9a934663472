#pragma once

#include <cstddef>
#include <vector>

#include "fourwis_navigation/model/point.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis::referee
{

/// A convex polygon with the outward normals of its sides: side i is from corner i to the next.
struct Shape
{
  std::vector<Point2> corners;  ///< counter-clockwise
  std::vector<Point2> normals;  ///< of length one

  bool empty() const { return corners.empty(); }
};

/// The body of a robot in the frame of C [m].
Shape body_shape(const Robot& robot);

/// The same with each side moved inward by `depth` [m]; empty where nothing is left.
Shape inset(const Shape& shape, double depth);

/// Distance of the farthest corner from the origin [m].
double greatest_radius(const Shape& shape);

}  // namespace fourwis::referee
