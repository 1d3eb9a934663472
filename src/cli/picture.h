#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// A mode's colour as #rrggbb.
std::string svg_colour(Mode mode);

/// What a picture of a plan shows. References must outlive the call they are passed to.
struct PlanPicture
{
  const OccupancyGrid& grid;
  ObstacleRule rule;  ///< which cells are drawn as occupied
  const Robot& robot;
  Pose start, goal;  ///< of base_link, map frame
  const PlanResult& result;
  std::vector<Corridor> corridors = {};     ///< drawn lightly below the plan
  std::vector<Trajectory> iterations = {};  ///< what the plan was made of: thin lines, the later the darker
};

/// Writes an SVG: map, footprints and path of the centre coloured by mode, start, goal, mode switches, corridors and iterations
/// where there are any, and a legend. Where there is no trajectory it shows the question and says why.
void write_svg(std::ostream& out, const PlanPicture& picture);

}  // namespace fourwis
