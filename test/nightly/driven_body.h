#pragma once

#include <functional>
#include <string>

#include "../support/rectangle.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis::nightly
{

/// What is wrong with a trajectory of C, the centre of the wheels, seen by driving it: a pose is forbidden at a sample, of which
/// there are so many that no point of the body moves more than 5 mm from one to the next; or the drive from one point does not
/// end at the next within 5 mm and 0.01 rad. Empty when nothing is wrong. Poses are asked for in their order. Shares no code
/// with the planner.
std::string fault_in_drive(const Trajectory& trajectory, const Robot& robot,
                           const std::function<bool(const Pose&)>& is_forbidden);

/// The same where the exact rectangle of the body must not meet an obstacle or leave the grid. A body that overlaps by
/// `start_tolerance` [m] or less at the start may go on overlapping until it is free, as long as it never gets deeper.
std::string fault_in_drive(const Trajectory& trajectory, const Robot& robot, const ExactRectangle& body,
                           double start_tolerance);

}  // namespace fourwis::nightly
