#pragma once

#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/referee/referee.h"
#include "report.h"

namespace fourwis::referee
{

/// One judgement: what is judged, by which limits, and where the violations go.
struct Judgement
{
  const Robot& robot;
  const RefereeOptions& options;
  const Trajectory& trajectory;
  Report& report;
  const Pose& frame;  ///< of grid and trajectory, in the frame that sentences tell poses in

  /// A limit with room for rounding.
  double lenient(double limit) const { return limit * (1.0 + options.limit_tolerance); }
};

constexpr double kRestSpeed = 1e-6;  ///< below this a point is at rest [m/s]

/// Differences of speeds or angles below this say nothing about their rates [m/s, rad].
constexpr double kRounding = 1e-12;

inline bool at_rest(const TrajectoryPoint& point)
{
  return point.v <= kRestSpeed && point.v >= -kRestSpeed;
}

/// Whether the points are a trajectory at all. The other checks may only be called for one.
bool check_form(const Judgement& judgement);

/// Start, goal, rest at both.
void check_ends(const Judgement& judgement, const Pose& start, const Pose& goal);

/// Speed and steering angle at the points, acceleration and steering rate between them, `a` and `omega`.
void check_limits(const Judgement& judgement);

/// Pose and time of the switches; rate, speed and travel of the wheels.
void check_wheels(const Judgement& judgement);

}  // namespace fourwis::referee
