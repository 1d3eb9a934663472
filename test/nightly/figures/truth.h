#pragma once

#include <array>
#include <vector>

#include "../../support/random.h"
#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis::nightly
{

/// What floods say of a problem.
enum class Verdict
{
  undecided,    ///< between the inner and the outer flood, however fine
  with_margin,  ///< the rectangle with its margin can
  bare_only,    ///< the rectangle can, with its margin it cannot
  impossible    ///< not even the rectangle can
};

const char* to_string(Verdict verdict);

/// Arcs of 2 cm, 6 cm and 12 cm.
inline constexpr std::array<int, 3> kShunts = {2, 6, 12};

struct Pair
{
  Pose start, goal;
  Verdict verdict = Verdict::undecided;
  bool end_is_tight = false;  ///< whether start or goal does not leave the margin
  bool discs_can = false;     ///< whether the paper's two discs with their margin can, too
  /// With margin: whether it can without turning in place, with shunts of so many degrees (kShunts) or more.
  std::array<bool, 3> without_spin = {};
};

/// Pairs of poses at which the bare rectangle is free. The origin of the grid is (0, 0, 0).
std::vector<Pair> random_pairs(const OccupancyGrid& grid, const Robot& robot, Random& random, int count);

/// Fills in what floods say, from coarse ones to fine ones.
void judge(const OccupancyGrid& grid, const Robot& robot, std::vector<Pair>& pairs);

}  // namespace fourwis::nightly
