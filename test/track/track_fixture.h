#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/planner/stop_and_steer.h"
#include "fourwis_navigation/track/tracker.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "ideal_base.h"

namespace fourwis
{

/// One piece after the other from `start`, with stops where steering, direction or mode change.
struct Piece
{
  Mode mode;
  double phi, length;
};

inline Trajectory trajectory_of(const Robot& robot, const Pose& start, const std::vector<Piece>& pieces, double speed = 1.0)
{
  Path path;
  Pose at = start;
  for (const Piece& piece : pieces)
  {
    path.pieces.push_back({piece.mode, at, piece.phi, piece.length});
    at = advance(robot, at, piece.mode, piece.phi, piece.length);
  }
  path.goal = at;
  return stop_and_steer(path, robot, speed);
}

/// A tracker that knows that IdealBase neither lags nor is late.
inline TrackOptions ideal_options()
{
  TrackOptions options;
  options.command_latency = options.drive_lag = options.steering_lag = 0.0;
  return options;
}

/// What a drive was like.
struct Drive
{
  TrackState state = TrackState::idle;
  std::string message;
  double seconds = 0.0;
  double worst_lateral = 0.0, worst_longitudinal = 0.0, worst_heading = 0.0;  ///< while driving
};

/// Steps tracker and base until the tracker rests, at most `patience` seconds.
inline Drive drive(Tracker& tracker, IdealBase& base, double period = 0.02, double patience = 120.0)
{
  Drive result;
  for (; result.seconds < patience; result.seconds += period)
  {
    const TrackOutput output = tracker.step({base.wheels().stamp, base.wheels().stamp, base.pose(), base.wheels()});
    result.state = output.state;
    result.message = output.message;
    if (output.state == TrackState::driving)
    {
      result.worst_lateral = std::max(result.worst_lateral, std::abs(output.lateral_error));
      result.worst_longitudinal = std::max(result.worst_longitudinal, std::abs(output.longitudinal_error));
      result.worst_heading = std::max(result.worst_heading, std::abs(output.heading_error));
    }
    base.step(output.command, period);
    const bool rests = output.state != TrackState::aligning && output.state != TrackState::driving &&
                       output.state != TrackState::stopping;
    if (rests) break;
  }
  return result;
}

}  // namespace fourwis
