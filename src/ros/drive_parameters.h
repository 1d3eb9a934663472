#pragma once

#include <string>

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/sim/simulator_options.h"
#include "fourwis_navigation/track/track_options.h"
#include "node_parameters.h"

namespace fourwis
{

/// The keys of `config/mpc_controller.yaml`, in the private namespace of mpc_controller_node.
struct MpcControllerOptions
{
  std::string global_frame = "map";            ///< frame of the trajectories
  std::string robot_base_frame = "base_link";  ///< the robot's centre; child_frame_id of `odom`
  double transform_tolerance = 0.5;            ///< how much older than odom the localisation's transform may be [s]
};

/// Everything that mpc_controller_node is configured with.
struct MpcControllerParameters
{
  Robot robot;
  TrackOptions track;
  MpcControllerOptions node;
};

/// The whole private namespace of the controller's node: its own keys, `robot/...` and `mpc/...`. Throws ConfigError.
MpcControllerParameters mpc_controller_parameters_from(const ParameterMap& parameters);

/// What a base calls its frames, and whether it is the one who publishes the transform between them.
struct BaseFrames
{
  std::string odom_frame = "odom";
  std::string robot_base_frame = "base_link";
  bool publish_odom_tf = true;
  double wheel_radius = 0.1;  ///< for the picture of turning wheels only [m]
};

/// The simulated base without a bus.
inline const std::string kDirect = "direct";

/// The keys of that; the wheel's radius is somebody else's. Throws ConfigError.
BaseFrames base_frames_from(KeyReader& reader);

/// The keys of `config/base_simulator.yaml`, in the private namespace of base_simulator_node.
struct BaseSimulatorNodeOptions
{
  std::string bus = kDirect;  ///< `direct`: takes wheel_commands itself; else drives on this bus, see can::open_bus()
  std::string global_frame = "map";
  BaseFrames frames;
  double publish_frequency = 100.0;  ///< cycles of simulated time each second; with a bus, of the true pose [Hz]
  double transform_tolerance = 0.1;  ///< how far ahead the ideal localisation dates its transform [s]
  bool publish_clock = true;         ///< without a bus: whether its time is everybody's
  double real_time_factor = 1.0;     ///< then: how much faster than real time
  double lockstep_period = 0.02;     ///< then: time waits for commands younger than this [s]; 0: never
  Pose initial;                      ///< where the robot is at first
};

/// Everything that base_simulator_node is configured with.
struct BaseSimulatorParameters
{
  Robot robot;
  SimulatorOptions simulator;
  BaseSimulatorNodeOptions node;
  can::BridgeOptions bridge;  ///< what drives there are on the bus
};

/// The whole private namespace of the simulator's node: its own keys, `robot/...`, `simulator/...` and, where there is
/// a bus, `can_bridge/...`. Throws ConfigError.
BaseSimulatorParameters base_simulator_parameters_from(const ParameterMap& parameters);

}  // namespace fourwis
