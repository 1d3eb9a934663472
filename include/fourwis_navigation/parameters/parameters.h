#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <variant>

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/planner/planner.h"
#include "fourwis_navigation/sim/simulator_options.h"
#include "fourwis_navigation/track/track_options.h"

namespace fourwis
{

/// Bad configuration. what() names key, value and allowed range.
struct ConfigError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

using ParameterValue = std::variant<bool, double, std::string>;

/// A flat list of keys, wherever it came from (YAML file, ROS parameter server). Nested maps are flattened with '/'.
using ParameterMap = std::map<std::string, ParameterValue>;

/// Reads a YAML file. Throws ConfigError naming the file and the line.
ParameterMap read_parameter_file(const std::string& path);

/// Every key of `config/robot.yaml`, once, in range; throws ConfigError for an unknown, missing or out-of-range key.
/// The keys are the names of Robot's members, SI units and radians.
Robot robot_from(const ParameterMap& parameters);

/// Likewise for `config/planner.yaml` and PlannerOptions. Whether the options fit together, Planner says.
PlannerOptions planner_options_from(const ParameterMap& parameters);

/// Likewise for `config/mpc.yaml` and TrackOptions.
TrackOptions track_options_from(const ParameterMap& parameters);

/// Likewise for `config/simulator.yaml` and SimulatorOptions.
SimulatorOptions simulator_options_from(const ParameterMap& parameters);

/// Likewise for `config/can_bridge.yaml` and BridgeOptions. Whether the options fit together, Bridge says.
can::BridgeOptions bridge_options_from(const ParameterMap& parameters);

/// Both steps for a file; every ConfigError also names the file.
Robot read_robot_file(const std::string& path);
PlannerOptions read_planner_file(const std::string& path);
TrackOptions read_track_file(const std::string& path);
SimulatorOptions read_simulator_file(const std::string& path);
can::BridgeOptions read_bridge_file(const std::string& path);

}  // namespace fourwis
