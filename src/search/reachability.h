#pragma once

#include "fourwis_navigation/search/goal_distance.h"
#include "fourwis_navigation/search/search_problem.h"

namespace fourwis
{

/// How a cell is found to hold no pose at which the robot is free.
enum class Proof
{
  quick,  ///< by the clearance at its centre: does not notice a gap that is too narrow by less than the cell's size
  sharp   ///< by the places where the discs may be: notices some millimetres, but looks at all of the map first
};

/// Whether a robot of the two-disc model might get from start to goal if it could move in any direction and turn in
/// place. False is a proof that no plan exists. True is no proof that one exists, because a cell counts as free if any
/// pose in it may be free. Floods (x, y, theta) from both ends until they meet or one flood is exhausted, so the
/// smaller side determines the cost. True if interrupted.
bool may_be_reachable(const SearchProblem& problem, const GoalDistance& distance, double cell_size, Proof proof);

}  // namespace fourwis
