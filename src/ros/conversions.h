#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Twist.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <std_msgs/Header.h>

#include "fourwis_navigation/ModeTrajectory.h"
#include "fourwis_navigation/PlanMetrics.h"
#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{

/// A message that cannot be represented here. what() is one sentence that names field, value and what was expected.
struct ConversionError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// How far from 1 the norm of a quaternion may be.
inline constexpr double kQuaternionTolerance = 1e-3;

/// How far a requested pose may be tilted out of the plane [rad].
inline constexpr double kMaxTilt = 0.05;

/// A robot on a ramp is tilted, and localisation says so; steeper than this, its transform is wrong [rad].
inline constexpr double kMaxRobotTilt = 0.35;

/// `name` is what the pose is called in errors. Rejects numbers that are not finite, quaternions that are not
/// normalised and poses tilted by more than `max_tilt` [rad]. The height is not looked at.
Pose to_pose(const geometry_msgs::Pose& message, const std::string& name, double max_tilt = kMaxTilt);
Pose to_pose(const geometry_msgs::Transform& message, const std::string& name, double max_tilt = kMaxTilt);

/// Rejects empty grids, data whose size is not width x height, resolutions and origins that make no sense.
void check_map(const nav_msgs::OccupancyGrid& message);

/// The same grid; rejects what check_map() rejects.
OccupancyGrid to_grid(const nav_msgs::OccupancyGrid& message);

/// Overwrites the rectangle of the update. Rejects one that does not lie in the grid, or has too much or too little
/// data; the grid is then as before.
void apply_update(const map_msgs::OccupancyGridUpdate& update, OccupancyGrid& grid);

/// The modes of these names, all for an empty list. Rejects unknown names.
ModeSet to_modes(const std::vector<std::string>& names);

geometry_msgs::Pose to_message(const Pose& pose);
/// `pose`, of the frame `child`, as it is in the header's frame.
geometry_msgs::TransformStamped to_message(const Pose& pose, const std_msgs::Header& header, const std::string& child);
geometry_msgs::Twist to_message(const Twist& twist);
nav_msgs::OccupancyGrid to_message(const OccupancyGrid& grid, const std_msgs::Header& header);
/// `robot` is the one that it was planned for.
fourwis_navigation::ModeTrajectory to_message(const Robot& robot, const Trajectory& trajectory,
                                              const std_msgs::Header& header);
fourwis_navigation::PlanMetrics to_message(const PlanMetrics& metrics);

/// The poses of a trajectory's points.
nav_msgs::Path to_path_message(const Trajectory& trajectory, const std_msgs::Header& header);

/// Poses along the front end's path, at most `step` [m] apart.
nav_msgs::Path to_path_message(const Robot& robot, const Path& path, const std_msgs::Header& header,
                               double step = 0.05);

}  // namespace fourwis
