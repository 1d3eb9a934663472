#pragma once

#include <vector>

#include "fourwis_navigation/model/point.h"
#include "fourwis_navigation/planner/planner.h"

namespace fourwis
{

/// Offsets from a goal on a square lattice, nearest first and without the goal itself: all not farther away than `radius`, at
/// every `step` [m]. A step that is longer than the radius is as long as it; one of which there would be more than some 2000
/// poses is made longer. Those equally far away come in the order of their direction, from -pi on.
std::vector<Point2> lattice_around(double radius, double step);

/// Poses within the goal's tolerance, with its heading, at which the body is clear, in the order of lattice_around(). Request and
/// poses are in the frame of the world's grid. The step is the side of a cell of the map or of the search, whichever is longer.
std::vector<Pose> free_goals_nearby(const World& world, const PlannerOptions& options, const PlanRequest& request);

}  // namespace fourwis
