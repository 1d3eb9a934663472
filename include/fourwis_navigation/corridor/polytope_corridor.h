#pragma once

#include <vector>

#include "fourwis_navigation/corridor/corridor_result.h"
#include "fourwis_navigation/corridor/obstacle_rectangles.h"
#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/vehicle/footprint.h"

namespace fourwis
{

struct PolytopeOptions
{
  double range = 2.0;        ///< a region reaches at most this far beyond its chord, ahead and to the sides [m]
  int max_half_planes = 12;  ///< of one region

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("range", o.range, 1e-3, 1e3, "m");
    row("max_half_planes", o.max_half_planes, 4, 1000);
  }
};

/// Throws std::invalid_argument naming key, value and range.
void check(const PolytopeOptions& options);

/// `deficit` is one per interval.
using PolytopeCorridor = CorridorResult<Corridor>;

/// Convex regions for the disc centres over the intervals between knots, the paper's future work in place of its boxes.
///
/// While the robot moves from one knot to the next, a disc centre moves about along the chord between its places at the
/// two knots. The region of the interval
///  - contains that chord, always;
///  - keeps the distance min(r_c + shrink, distance of the chord) to every obstacle and to the map's border: `deficit`
///    is how much the second is less than the first, for the worst of the discs. The chord of an arc whose every
///    point is r_c away may come closer by the arc's sagitta: the region then gives way by that much, towards that
///    obstacle only;
///  - is an intersection of half-planes, each of them as far out as its obstacle or the range allows.
///
/// Obstacle by obstacle, nearest first: let p on the chord and q on the obstacle be the nearest points, n the unit
/// vector from p to q. The half-plane n x <= n q - min(r_c + shrink, |q - p|) holds the chord, since no point of it
/// lies beyond p along n, and keeps its distance, since the obstacle, convex, lies beyond q. All else that lies that
/// far beyond the half-plane needs none of its own. If the half-planes are used up before the obstacles are, and the
/// nearest of those left is d + r_c + shrink away, the range is cut to d/sqrt(2): the corners of a rectangle that
/// reaches so far beyond the chord are d away from it.
///
/// `shrink` (one per interval, or none) makes regions smaller [m] where a trajectory came too close between knots; not
/// negative. Coinciding knots are fine. Throws as check() does.
PolytopeCorridor polytope_corridor(const ObstacleRectangles& obstacles, const DiscCover& discs,
                                   const PolytopeOptions& options, const std::vector<Pose>& knots,
                                   const std::vector<double>& shrink = {});

/// Corners in counter-clockwise order of that part of a polytope which lies within the square of half side `reach` [m]
/// around a point; for pictures.
std::vector<Point2> corners(const Polytope& polytope, const Point2& centre, double reach);

}  // namespace fourwis
