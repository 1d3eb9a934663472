#pragma once

#include <vector>

#include "fourwis_navigation/corridor/corridor_result.h"
#include "fourwis_navigation/corridor/obstacle_rectangles.h"
#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/vehicle/footprint.h"

namespace fourwis
{

struct BoxOptions
{
  double coarse_step = 0.5;    ///< Delta d_1 [m]
  double fine_step = 0.05;     ///< Delta d_2 [m]
  double max_expansion = 5.0;  ///< d_max, of each side from the waypoint [m]

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("coarse_step", o.coarse_step, 1e-3, 1e3, "m");
    row("fine_step", o.fine_step, 1e-3, 1e3, "m");
    row("max_expansion", o.max_expansion, 1e-3, 1e3, "m");
  }
};

/// Throws std::invalid_argument naming key, value and range; also unless fine_step <= coarse_step <= max_expansion.
void check(const BoxOptions& options);

/// `deficit` is one per knot.
using BoxCorridorResult = CorridorResult<BoxCorridor>;

/// The paper's Algorithm 2: for each knot, boxes around the two disc centres. They are axis-aligned in the map frame,
/// also if the grid is turned. They grow side by side, first coarsely, then finely. The side that faces most along the
/// motion of the disc centre to its next place grows first, then the side of the motion's other component, then the
/// sides opposite to the two.
///
/// Every point of a box is min(r_c, distance of the waypoint) away from every obstacle and from the map's border:
/// `deficit` is how much the second is less than the first, for the worse of the two discs. The test is exact: a box
/// grown by a disc is free if no obstacle's rectangle is nearer to the box than the disc's radius.
///
/// Deviations from the paper: boxes grow from the waypoint itself, because the paper's square of side Delta d_1 may
/// collide beside a wall. No side goes beyond d_max; the paper checks that only before a step.
///
/// Throws as check() does.
BoxCorridorResult box_corridor(const ObstacleRectangles& obstacles, const TwoDiscs& discs, const BoxOptions& options,
                               const std::vector<Pose>& knots);

}  // namespace fourwis
