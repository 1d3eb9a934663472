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

/// Convex regions for the disc centres over the intervals between knots, which the paper names as future work, in place
/// of its boxes.
///
/// While the robot moves from one knot to the next, a disc centre moves approximately along the chord between its
/// places at the two knots. The region of the interval
///  - contains that chord, always;
///  - keeps the distance min(r_c + shrink, distance of the chord) to every obstacle and to the map's border: `deficit`
///    is how much the second is less than the first, for the worst of the discs. If every point of an arc is r_c
///    away, its chord may come closer by the arc's sagitta. Then the region keeps that much less, from that obstacle
///    only;
///  - is an intersection of half-planes, each of them as far out as its obstacle or the range allows.
///
/// Half-planes are made obstacle by obstacle, nearest first. Let p on the chord and q on the obstacle be the nearest
/// points, and n the unit vector from p to q. The half-plane is n x <= n q - min(r_c + shrink, |q - p|). It contains
/// the chord, because no point of the chord lies beyond p along n. It keeps its distance, because the obstacle is
/// convex and lies beyond q. Other obstacles that lie that far beyond the half-plane need none of their own. If there
/// are more obstacles than half-planes, let the nearest of the remaining ones be d + r_c + shrink away. Then the range
/// is cut to d/sqrt(2): the corners of a rectangle that reaches so far beyond the chord are d away from it.
///
/// `shrink` (one per interval, or none; not negative) makes regions smaller [m] where a trajectory came too close
/// between knots. Knots may coincide. Throws as check() does.
PolytopeCorridor polytope_corridor(const ObstacleRectangles& obstacles, const DiscCover& discs,
                                   const PolytopeOptions& options, const std::vector<Pose>& knots,
                                   const std::vector<double>& shrink = {});

/// Corners in counter-clockwise order of that part of a polytope which lies within the square of half side `reach` [m]
/// around a point; for pictures.
std::vector<Point2> corners(const Polytope& polytope, const Point2& centre, double reach);

}  // namespace fourwis
