#pragma once

#include "../support/random.h"
#include "../support/rectangle.h"
#include "fourwis_navigation/planner/planner.h"
#include "rectangle_flood.h"

namespace fourwis::nightly
{

/// 4 to 7 m on each side: boxes, and walls across it with gaps about as wide as the robot.
OccupancyGrid random_grid(Random& random);

/// A grid and all that is asked of it.
struct Place
{
  Place(const OccupancyGrid& occupancy, const Robot& its_robot, const PlannerOptions& options);
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;

  /// A request between poses of the flood's lattice, most of them free, with any set of modes.
  PlanRequest request(Random& random) const;

  Robot robot;
  OccupancyGrid grid;  ///< its origin is (0, 0, 0)
  World world;
  ExactRectangle body;
  RectangleFlood flood;  ///< where it joins two poses, the body has a way with the safety margin

private:
  Pose pose(Random& random) const;
};

/// What in an answer is wrong; empty when nothing is.
///   succeeded            the body meets no obstacle, and the drive begins and ends where it should
///   goal_unreachable     the flood knows no way
///   start_in_collision,
///   goal_in_collision    the body overlaps an obstacle there
std::string fault_in_answer(const Place& place, const PlanRequest& request, const PlanResult& result);

}  // namespace fourwis::nightly
