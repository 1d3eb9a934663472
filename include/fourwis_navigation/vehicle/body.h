#pragma once

#include <vector>

#include "fourwis_navigation/model/point.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// A convex polygon in the frame of C, the centre of the wheels: its corners counter-clockwise [m].
using ConvexPolygon = std::vector<Point2>;

/// The robot's body, seen from above.
ConvexPolygon body_of(const Robot& robot);

/// The polygon with each side moved outward by `margin` [m], inward where that is negative. Empty where nothing is left.
ConvexPolygon grown(const ConvexPolygon& polygon, double margin);

/// Distance of the farthest corner from C [m].
double reach_of(const ConvexPolygon& polygon);

/// Radius of the largest disc around C within the polygon [m]; 0 if C lies outside.
double inner_radius_of(const ConvexPolygon& polygon);

}  // namespace fourwis
