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

/// Whether a robot of the two-disc model that could move freely, in any direction and turning on the spot, might get from
/// start to goal. False is a proof that no plan exists; true is none that one does: cells are taken as free when any pose
/// in them may be. Floods (x, y, theta) from both ends until they meet or one is exhausted, so the cost goes with
/// the smaller side. True when interrupted.
bool may_be_reachable(const SearchProblem& problem, const GoalDistance& distance, double cell_size, Proof proof);

}  // namespace fourwis
