#pragma once

#include <string>
#include <vector>

#include "fourwis_navigation/parameters/node_options.h"
#include "fourwis_navigation/parameters/parameters.h"

namespace fourwis
{

// The whole private namespace of each node. What reads one throws ConfigError for an unknown or out-of-range key, and names
// the group where it is in one. Missing keys take their defaults; `defaults` has a sentence for each group with such keys.

/// Everything that global_planner_node is configured with.
struct GlobalPlannerParameters
{
  Robot robot;
  PlannerOptions planner;
  GlobalPlannerOptions node;
  std::vector<std::string> defaults;
};

/// Its own keys, `robot/...` and `planner/...`.
GlobalPlannerParameters global_planner_parameters_from(const ParameterMap& parameters);

/// Everything that mpc_controller_node is configured with.
struct MpcControllerParameters
{
  Robot robot;
  TrackOptions track;
  MpcControllerOptions node;
  std::vector<std::string> defaults;
};

/// Its own keys, `robot/...` and `mpc/...`.
MpcControllerParameters mpc_controller_parameters_from(const ParameterMap& parameters);

/// Everything that can_bridge_node is configured with.
struct CanBridgeParameters
{
  Robot robot;
  can::BridgeOptions bridge;
  CanBridgeNodeOptions node;
  std::vector<std::string> defaults;
};

/// Its own keys, `robot/...` and `can_bridge/...`.
CanBridgeParameters can_bridge_parameters_from(const ParameterMap& parameters);

/// Everything that base_simulator_node is configured with.
struct BaseSimulatorParameters
{
  Robot robot;
  SimulatorOptions simulator;
  BaseSimulatorNodeOptions node;
  can::BridgeOptions bridge;  ///< what drives there are on the bus
  std::vector<std::string> defaults;
};

/// Its own keys, `robot/...`, `simulator/...` and, where there is a bus, `can_bridge/...`.
BaseSimulatorParameters base_simulator_parameters_from(const ParameterMap& parameters);

/// Missing keys take their defaults, `map_file` that of `argument`; it must not be empty.
MapPublisherOptions map_publisher_options_from(const ParameterMap& parameters, const std::string& argument);

/// Missing keys but `octomap_file` take their defaults.
OctomapProjectorOptions octomap_projector_options_from(const ParameterMap& parameters);

}  // namespace fourwis
