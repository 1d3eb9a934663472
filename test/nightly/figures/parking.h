#pragma once

#include <string>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis::nightly
{

/// A car to be parked, or to leave where it is parked. Poses are those of the body's centre.
struct ParkingCase
{
  std::string name;
  OccupancyGrid grid;
  Pose start, goal;
};

/// 4.7 m by 1.9 m, wheelbase 2.8 m: that of third-party parking cases.
Robot car();

/// So many cases: parallel, perpendicular and angled bays between other cars, at street edges and in car parks, in turn.
std::vector<ParkingCase> parking_cases(int count);

}  // namespace fourwis::nightly
