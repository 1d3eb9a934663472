#pragma once

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/interrupt.h"
#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// What stays the same for all searches of a plan; their modes and costs differ.
struct SearchProblem
{
  const CollisionChecker& checker;  ///< the robot on its map; must outlive the problem
  Pose start, goal;                 ///< map frame, both free
  Interrupt interrupt = {};
};

}  // namespace fourwis
