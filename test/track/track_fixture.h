#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/track/tracker.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "ideal_base.h"
#include "planner/stop_and_steer.h"

namespace fourwis
{

/// A piece of a path: mode, steering angle, signed length.
struct Piece
{
  Mode mode;
  double phi, length;
};

/// A trajectory of these pieces, with stops where steering angle, direction or mode change.
inline Trajectory trajectory_of(const Robot& robot, const Pose& start, const std::vector<Piece>& pieces)
{
  Path path;
  Pose at = start;
  for (const Piece& piece : pieces)
  {
    path.pieces.push_back({piece.mode, at, piece.phi, piece.length});
    at = advance(robot, at, piece.mode, piece.phi, piece.length);
  }
  path.goal = at;
  return stop_and_steer(path, robot);
}

/// The options for a base without lag and latency.
inline TrackOptions ideal_options()
{
  TrackOptions options;
  options.command_latency = options.drive_lag = options.steering_lag = 0.0;
  return options;
}

inline bool is_resting(TrackState state)
{
  return state != TrackState::aligning && state != TrackState::driving && state != TrackState::stopping;
}

/// A tracker on an ideal base, and a way to change its input in between.
class Rig
{
public:
  explicit Rig(const Pose& start = {}, const TrackOptions& options = ideal_options())
    : base(robot, start),
      tracker(robot, options),
      period(1.0 / options.controller_frequency)
  {}

  /// One control step.
  const TrackOutput& step()
  {
    TrackInput input = {base.wheels().stamp + clock, base.wheels().stamp + clock, base.pose(), base.wheels()};
    input.wheels.stamp += clock;
    if (tamper) tamper(input);
    output = tracker.step(input);
    message = std::string(output.message);
    base.step(output.command, period);
    return output;
  }

  /// Steps until the condition is true, or for `patience` [s].
  bool step_until(const std::function<bool()>& reached, double patience = 120.0)
  {
    for (double time = 0.0; time < patience; time += period)
    {
      step();
      if (reached()) return true;
    }
    return false;
  }
  bool step_until(TrackState state, double patience = 120.0)
  {
    return step_until([&] { return output.state == state; }, patience);
  }
  bool step_until_rest()
  {
    return step_until([&] { return is_resting(output.state); });
  }

  /// Steps until it drives faster than that speed [m/s].
  bool step_until_fast(double speed = 0.5)
  {
    return step_until([&] { return output.state == TrackState::driving && std::abs(output.speed) > speed; });
  }

  const Robot robot;
  IdealBase base;
  Tracker tracker;
  const double period;
  double clock = 0.0;                       ///< error of the clock [s]
  std::function<void(TrackInput&)> tamper;  ///< changes the input of the tracker
  TrackOutput output;
  std::string message;  ///< of the last step
};

}  // namespace fourwis
