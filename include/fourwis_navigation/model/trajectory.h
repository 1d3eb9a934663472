#pragma once

#include <vector>

#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/pose.h"

namespace fourwis
{

/// One point of a trajectory. Between two neighbours of one mode, v and phi vary linearly in time and the pose follows
/// the mode's kinematics; between two neighbours of different modes lies a switch, at rest (doc/design.md, "The meaning
/// of a trajectory").
struct TrajectoryPoint
{
  double t = 0.0;  ///< time from the start [s]
  Mode mode = Mode::none;
  double x = 0.0, y = 0.0;  ///< position of the centre C, map frame [m]
  double theta = 0.0;       ///< heading, continuous along the trajectory, not wrapped [rad]
  double v = 0.0;           ///< signed speed of C [m/s]
  double phi = 0.0;         ///< equivalent steering angle [rad]
  double a = 0.0;           ///< acceleration from here to the next point [m/s^2]
  double omega = 0.0;       ///< steering rate d phi / dt from here to the next point [rad/s]

  Pose pose() const { return {x, y, theta}; }
};

using Trajectory = std::vector<TrajectoryPoint>;

}  // namespace fourwis
