#pragma once

#include <string>
#include <vector>

#include "../../support/random.h"
#include "fourwis_navigation/model/occupancy_grid.h"

namespace fourwis::nightly
{

/// A kind of places, drawn for a robot of 1.0 m by 0.62 m. For a robot k times as big, everything is k times as big, the cells
/// as well.
struct MapKind
{
  const char* name;
  OccupancyGrid (*draw)(Random& random, double scale);
};

/// Thirteen of them.
const std::vector<MapKind>& map_kinds();

}  // namespace fourwis::nightly
