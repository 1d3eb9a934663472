#pragma once

#include <string>
#include <vector>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis::nightly
{

/// A line of problems/failing/cases.csv, with what its files hold.
struct FileCase
{
  std::string id;
  OccupancyGrid grid;
  Robot robot;
  Pose start, goal;
  ModeSet modes;
};

/// `id;map;start;goal;robot;modes;...`, paths relative to the file. Throws std::runtime_error naming file and line.
std::vector<FileCase> read_cases(const std::string& path);

}  // namespace fourwis::nightly
