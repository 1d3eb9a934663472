#pragma once

#include <vector>

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

/// Regions for the disc centres, one of each per interval of a segment. Any point of one is at least r_c away from every
/// obstacle.
struct Corridor
{
  std::vector<Polytope> front;
  std::vector<Polytope> rear;
};

/// The paper's regions, one of each per knot.
struct BoxCorridor
{
  std::vector<Box> front;
  std::vector<Box> rear;
};

}  // namespace fourwis
