#pragma once

#include <vector>

#include "fourwis_navigation/model/point.h"

namespace fourwis
{

/// The points with a x + b y <= c, map frame; (a, b) has length one.
struct HalfPlane
{
  double a, b, c;
};

/// Convex region of the plane: the points in all half-planes.
using Polytope = std::vector<HalfPlane>;

/// Axis-aligned rectangle in the map frame [m].
struct Box
{
  double x_min, y_min, x_max, y_max;
};

/// Where the centre of one of the discs that cover the body may be.
struct DiscRegions
{
  Point2 centre;                  ///< of the disc, on the body [m]
  std::vector<Polytope> regions;  ///< one per interval of a segment
};

/// The regions of all discs, from front to rear. Any point of a region is at least the discs' radius away from every
/// obstacle.
using Corridor = std::vector<DiscRegions>;

/// The paper's regions, one of each per knot.
struct BoxCorridor
{
  std::vector<Box> front;
  std::vector<Box> rear;
};

}  // namespace fourwis
