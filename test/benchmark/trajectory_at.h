#pragma once

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis::benchmark
{

/// The trajectory at time t, its kinematics integrated from the point before in small steps: the referee of tracking
/// errors, which shares nothing with the tracker.
TrajectoryPoint trajectory_at(const Robot& robot, const Trajectory& trajectory, double t);

/// Its duration without the switches [s].
double driving_time(const Trajectory& trajectory);

}  // namespace fourwis::benchmark
