#pragma once

#include <string>

#include "fourwis_navigation/map/map_file.h"
#include "fourwis_navigation/model/occupancy_grid.h"

namespace fourwis
{

/// Which heights of a 3D map the robot sweeps.
struct HeightBand
{
  double min = 0.1;  ///< lowest height that matters [m], map frame
  double max = 1.0;  ///< greatest [m]

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("min_height", o.min, -1e6, 1e6, "m");
    row("max_height", o.max, -1e6, 1e6, "m");
  }
};

/// Throws std::invalid_argument naming key, value and range; also unless min < max.
void check(const HeightBand& band);

/// Projects an OctoMap file (.bt or .ot) to a grid at the tree's resolution: occupied (100) where any voxel of the band is
/// occupied, else free (0) where any is known free, else unknown (-1). Voxels that only touch the band do not count. The
/// grid covers the known voxels of the band and lies on the tree's lattice. The path may begin with "~/".
/// Throws MapFileError, and as check() does.
OccupancyGrid project_octomap_file(const std::string& path, const HeightBand& band);

}  // namespace fourwis
