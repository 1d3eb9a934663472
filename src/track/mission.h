#pragma once

#include <string>
#include <vector>

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"
#include "reference.h"

namespace fourwis
{

/// A trajectory cut at its switches.
using Mission = std::vector<Reference>;

Mission mission_of(const Robot& robot, const Trajectory& trajectory);

}  // namespace fourwis
