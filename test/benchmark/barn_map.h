#pragma once

#include <string>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"

namespace fourwis::benchmark
{

/// A map of the BARN dataset: one corridor that runs in +y, its lower half open, its upper half full of obstacles.
struct BarnMap
{
  std::string name;    ///< file name without its ending
  OccupancyGrid grid;  ///< black pixels are obstacles, white ones are free
  double top = 0.0;    ///< y of the upper edge of the dataset's map [m]
};

/// All map_pgm_*.pgm of a folder, in the order of their numbers. The maps end where the obstacles end, but the
/// dataset's world is open there: `margin` metres of free cells are put above, so that the robot has to come all
/// the way through. Throws std::runtime_error when there are none, or one is unusable.
std::vector<BarnMap> read_barn_maps(const std::string& folder, double margin);

}  // namespace fourwis::benchmark
