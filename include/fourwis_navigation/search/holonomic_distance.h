#pragma once

#include <cstdint>
#include <vector>

#include "fourwis_navigation/search/goal_distance.h"
#include "fourwis_navigation/search/search_problem.h"

namespace fourwis
{

/// About how far a robot of the two-disc model that could move in any direction and turn on the spot has to travel to the
/// goal: breadth first over (x, y, theta mod pi). Knows, unlike GoalDistance, through which gaps the robot only fits at
/// certain headings; takes tens of milliseconds, so it is for searches that have failed without it.
class HolonomicDistance
{
public:
  /// Computes the field until the start is reached and `slack` metres beyond. Stops early, with a field of no use, when
  /// interrupted.
  HolonomicDistance(const SearchProblem& problem, double cell_size, double slack);

  /// Distance to the goal [m], turning on the spot charged like driving a cell for each bin of heading.
  double operator()(const Pose& pose) const;

  /// False is a proof that no plan exists.
  bool reaches_start() const { return reaches_start_; }

private:
  std::size_t state(int cell, int heading) const;

  CoarseCells cells_;
  bool reaches_start_ = false;
  int edge_ = 0;  ///< steps to where the field ends
  std::vector<std::uint16_t> steps_;
};

}  // namespace fourwis
