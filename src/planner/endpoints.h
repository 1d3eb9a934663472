#pragma once

#include <string>

#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/planner/planner.h"

namespace fourwis
{

/// How the body stands at the start or at the goal.
struct Endpoint
{
  double clearance =
      0.0;  ///< of each side of the body to obstacles, at most the safety margin [m]; negative: it overlaps
  bool off_map = false;  ///< part of the body lies outside the grid
  bool unseen = false;   ///< what it overlaps are cells that no sensor has seen
};

/// At a pose in the frame of the world's grid.
Endpoint endpoint(const World& world, const PlannerOptions& options, const Pose& pose);

/// Why nothing can be planned from or to a pose; `place` is "start" or "goal", `asked` the pose in the map frame, `pose` the
/// same in the grid's.
std::string collision_sentence(const World& world, const Endpoint& endpoint, const char* place, const Pose& asked,
                               const Pose& pose);

/// Whether the body at the start overlaps cells that no sensor has seen and that count as obstacles.
bool stands_on_unseen_ground(const World& world, const Pose& pose);

/// The grid with the cells under the body at a pose free where no sensor has seen them: a robot stands on free ground.
OccupancyGrid with_free_ground(OccupancyGrid grid, const World& world, const Pose& pose);

}  // namespace fourwis
