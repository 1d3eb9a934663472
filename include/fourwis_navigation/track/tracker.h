#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/track/track_options.h"

namespace fourwis
{

/// What the tracker is doing; the numbers are those of the message Tracking.
enum class TrackState : std::uint8_t
{
  idle = 0,      ///< no trajectory
  aligning = 1,  ///< at rest, the wheels turn to the angles of the next stretch
  driving = 2,
  stopping = 3,  ///< braking, because it was told to or because of what `message` says
  arrived = 4,   ///< at rest at the goal
  failed = 5     ///< at rest, the trajectory is given up because of what `message` says
};

/// Until when the way is known to be free. By default all of it is.
struct DrivePermission
{
  double free_until =
      std::numeric_limits<double>::infinity();  ///< of the trajectory [s]; the robot comes to rest before it
  double age = 0.0;  ///< of the controller's own stamp that had been heard where it was given [s]; infinite: never
};

/// What is known of the robot when a control step begins. Any part may be old, missing or wrong: the tracker checks it.
struct TrackInput
{
  double now = 0.0;         ///< [s]
  double pose_stamp = 0.0;  ///< when `pose` was true [s]
  Pose pose;                ///< of the robot in the trajectory's frame; NaN where it is not known
  WheelState wheels;        ///< with its own stamp
  DrivePermission permission = {};
};

/// One control step's answer.
struct TrackOutput
{
  WheelCommand command;  ///< with its sequence: `aligned` counts once the base has taken a command of this alignment
  TrackState state = TrackState::idle;
  std::string_view message;         ///< why it stops, waits or failed, otherwise empty; valid until the next step
  double t = 0.0;                   ///< time on the trajectory at which the robot should be at `pose_stamp`; while
                                    ///< stopping, where it began to stop; 0 in the states at rest [s]
  double lateral_error = 0.0;       ///< of the measured pose, to the left of the direction of travel [m]
  double longitudinal_error = 0.0;  ///< along the direction of travel [m]
  double heading_error = 0.0;       ///< [rad]
  double speed = 0.0;               ///< v that the command stands for [m/s]
  double phi = 0.0;                 ///< phi that the command stands for [rad]
};

/// Drives the wheels along a trajectory. At each switch it brakes to rest, turns the wheels and waits until they are
/// aligned. Then it goes on, with the trajectory's clock shifted. In between a model-predictive controller follows the
/// trajectory. Without permission it comes to rest on its way, and goes on with it. A stop is
/// possible at any time. step() neither allocates nor locks. Deterministic: the answers depend
/// only on the calls before.
class Tracker
{
public:
  /// Throws as their check() does.
  Tracker(const Robot& robot, const TrackOptions& options);
  ~Tracker();

  /// Takes a trajectory to drive from its beginning. If it refuses it, it says why in a sentence, and the trajectory
  /// before goes on. A robot that is driving stops first. If it then rests near the new beginning it starts, otherwise
  /// the state is `failed`. An empty trajectory stops the robot.
  std::string accept(const Trajectory& trajectory);

  /// Brakes to rest and forgets the trajectory.
  void stop();

  /// One control step; to be called at the control rate. Always answers with a command that is safe to send.
  TrackOutput step(const TrackInput& input);

  /// Where the last step expects the robot over the horizon, one pose a knot; empty unless driving.
  const std::vector<Pose>& prediction() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fourwis
