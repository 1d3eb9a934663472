#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "fourwis_navigation/search/search_problem.h"
#include "goal_distance.h"
#include "heading_slices.h"

namespace fourwis
{

/// The approximate distance to the goal for a body that can move in any direction and turn in place: breadth first over
/// cells and headings at which it is free at one of four points of the cell. Unlike GoalDistance, it considers at which headings the body fits
/// through a gap. It takes tens of milliseconds, so it is used only after a search without it has failed.
class HolonomicDistance
{
public:
  /// Computes the field until the start is reached and `slack` metres beyond. If interrupted it stops early, and the
  /// field is not usable.
  HolonomicDistance(const SearchProblem& problem, double spacing, double slack);

  /// Distance to the goal [m]. Turning in place by one bin of heading costs as much as driving one cell.
  double operator()(const Pose& pose) const;

  /// Where a robot goes on from a pose if it keeps its heading: points of neighbouring cells, each nearer to the goal than the
  /// one before. Empty if it has to turn first.
  void way_ahead(const Pose& pose, std::vector<Pose>& points) const;

  /// Whether the field covers the start. If not there may still be a way, between the centres of the cells.
  bool reaches_start() const { return reaches_start_; }

private:
  std::size_t state(int cell, int heading) const;

  /// Columns and rows of a cell's points.
  std::array<std::pair<int, int>, 4> points_of(int cell) const;
  Pose free_point(int cell, int heading, const Pose& near) const;

  const ObstacleMap& map_;
  HeadingSlices points_;
  CoarseCells cells_;  ///< of two by two points
  bool reaches_start_ = false;
  int edge_ = 0;  ///< steps to where the field ends
  std::vector<std::uint16_t> steps_;
};

}  // namespace fourwis
