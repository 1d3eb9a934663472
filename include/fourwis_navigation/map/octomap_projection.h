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
};

/// Projects an OctoMap file (.bt or .ot) to a grid at the tree's resolution: occupied (100) where any voxel of the band is
/// occupied, else free (0) where any is known free, else unknown (-1). Throws MapFileError.
OccupancyGrid project_octomap_file(const std::string& path, const HeightBand& band);

}  // namespace fourwis
