#pragma once

#include <vector>

#include "closest_points.h"
#include "fourwis_navigation/corridor/polytope_corridor.h"

namespace fourwis
{

/// The region of one chord, in the grid's frame.
struct ChordRegion
{
  Polytope planes;       ///< empty when the chord meets an obstacle
  double deficit = 0.0;  ///< how much less than the wanted distance the region keeps [m]
};

/// See polytope_corridor(); `keep` is the distance asked for, r_c + shrink [m].
ChordRegion chord_region(const ObstacleRectangles& obstacles, const Chord& chord, double keep,
                         const PolytopeOptions& options);

}  // namespace fourwis
