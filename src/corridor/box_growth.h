#pragma once

#include "fourwis_navigation/corridor/box_corridor.h"

namespace fourwis
{

/// The paper's Algorithm 2 for one waypoint, which must lie `radius` or more away from every obstacle. Then every point
/// of the box does so as well. `motion` is the way to the next waypoint, map frame; see box_corridor().
Box grow_box(const ObstacleRectangles& obstacles, const Pose& waypoint, const Point2& motion, double radius,
             const BoxOptions& options);

}  // namespace fourwis
