#pragma once

#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// One outer iteration of a segment: the regions, and what the solver found in them, from t = 0.
struct RefinementRound
{
  Corridor corridor;
  Trajectory points;
};

}  // namespace fourwis
