#pragma once

#include <vector>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

/// A stretch of a trajectory in one mode, as the poses it passes through.
struct ModeRun
{
  Mode mode = Mode::none;
  std::vector<Pose> poses;  ///< never empty
};

/// Poses along a trajectory about `step` metres apart, for drawing: the model is integrated between the points. Points
/// that are not finite are left out.
std::vector<ModeRun> sample_motion(const Robot& robot, const Trajectory& trajectory, double step);

/// Those of the poses that are at least `least_distance` metres or `least_angle` radians from the one chosen before,
/// and both ends.
std::vector<Pose> thin_out(const std::vector<Pose>& poses, double least_distance, double least_angle);

}  // namespace fourwis
