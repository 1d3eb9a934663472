#pragma once

#include <cstdint>
#include <vector>

#include "fourwis_navigation/search/goal_distance.h"
#include "fourwis_navigation/search/search_problem.h"

namespace fourwis
{

/// The approximate distance to the goal for a robot of the two-disc model that can move in any direction and turn in
/// place: breadth first over (x, y, theta mod pi). Unlike GoalDistance, it considers at which headings the robot fits
/// through a gap. It takes tens of milliseconds, so it is used only after a search without it has failed.
class HolonomicDistance
{
public:
  /// Computes the field until the start is reached and `slack` metres beyond. If interrupted it stops early, and the
  /// field is not usable.
  HolonomicDistance(const SearchProblem& problem, double cell_size, double slack);

  /// Distance to the goal [m]. Turning in place by one bin of heading costs as much as driving one cell.
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
