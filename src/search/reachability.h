#pragma once

#include "fourwis_navigation/search/search_problem.h"
#include "goal_distance.h"

namespace fourwis
{

/// Whether the body may get from start to goal if it can move in any direction and turn in place. False is a proof that no plan
/// exists for the checker's body, with its margin. True if interrupted, or if the proof would take too long.
///
/// First a flood goes through a lattice of poses of the given spacing, wherever the body may be free next to them. It is soon
/// over where the body has no room to turn. Then the space of poses is covered by boxes of (x, y, theta). Each is free, blocked or mixed: the body is free at all of its poses,
/// at none, or one cannot tell. The cheapest chain of boxes from start to goal that are not blocked is looked for again and
/// again. The mixed boxes on it are halved in all directions each time, until it is free or there is none.
bool may_be_reachable(const SearchProblem& problem, const GoalDistance& distance, double spacing);

}  // namespace fourwis
