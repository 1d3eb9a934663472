#pragma once

#include <ostream>

#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// Writes a plan as JSON, one trajectory point a line. Throws std::logic_error when a number is not finite.
void write_json(std::ostream& out, const PlanResult& result);

/// Writes the header t,mode,x,y,theta,v,phi,a,omega and one line for each point; numbers read back exactly.
void write_csv(std::ostream& out, const Trajectory& trajectory);

}  // namespace fourwis
