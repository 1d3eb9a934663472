#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/sim/simulator_options.h"
#include "fourwis_navigation/track/tracker.h"

namespace fourwis::benchmark
{

/// What the tracker is told of the robot's pose: the truth, late and with noise.
struct Localisation
{
  double delay = 0.0;          ///< age of the pose at the control step [s]
  double deviation = 0.0;      ///< standard deviation of x and y [m]
  double yaw_deviation = 0.0;  ///< [rad]
};

/// A moment at which the robot is moved aside.
struct Push
{
  double at = 0.0;  ///< time of the trajectory [s]
  Pose by;          ///< in the robot's frame
};

struct DriveConditions
{
  Robot robot;
  TrackOptions track;
  SimulatorOptions simulator;
  Localisation localisation;
  std::optional<Push> push;
};

/// What became of a drive. Errors are those of the true pose against the trajectory at the tracker's clock while it
/// drives; at rest, aligning, there are none.
struct DriveResult
{
  TrackState state = TrackState::idle;
  std::string message;
  std::vector<double> lateral, longitudinal, heading;      ///< absolute [m, m, rad]
  double terminal_position = 0.0, terminal_heading = 0.0;  ///< [m, rad]
  double driving = 0.0, aligning = 0.0;                    ///< time spent [s]
  std::vector<double> step_ms;                             ///< of control steps while driving, CPU time
  bool collided = false;                                   ///< the exact footprint met an obstacle cell
};

/// Drives a trajectory on simulated time until the tracker is done with it. `grid`: where obstacles are; may be null.
DriveResult simulate(const DriveConditions& conditions, const Trajectory& trajectory, const OccupancyGrid* grid,
                     int seed);

}  // namespace fourwis::benchmark
