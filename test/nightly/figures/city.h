#pragma once

#include <string>

#include "../../support/random.h"
#include "fourwis_navigation/model/occupancy_grid.h"

namespace fourwis::nightly
{

/// A drive through a city. Poses are on streets.
struct CityDrive
{
  std::string name;
  OccupancyGrid grid;
  Pose start, goal;
  double way;  ///< length of a shortest way of a disc of 0.6 m, over the cells [m]
};

/// Blocks of houses, streets of 2.5 to 8 m, some closed, an avenue across, and what stands about; as large as a way of about this
/// length takes [m]. Number and cells decide everything.
CityDrive city_drive(int number, double way, double resolution);

}  // namespace fourwis::nightly
