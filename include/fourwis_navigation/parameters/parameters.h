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

/// Reads a YAML file; its path may begin with "~/". Throws ConfigError naming the file and the line.
ParameterMap read_parameter_file(const std::string& path);

/// The keys of `config/robot.yaml` are the names of Robot's members, SI units and radians. One that is missing takes its
/// default, so that files of older versions go on working. Throws ConfigError for an unknown or out-of-range key.
Robot robot_from(const ParameterMap& parameters);

/// Likewise for `config/planner.yaml` and PlannerOptions. Whether the options fit together, Planner says.
PlannerOptions planner_options_from(const ParameterMap& parameters);

/// Likewise for `config/mpc.yaml` and TrackOptions.
TrackOptions track_options_from(const ParameterMap& parameters);

/// Likewise for `config/simulator.yaml` and SimulatorOptions.
SimulatorOptions simulator_options_from(const ParameterMap& parameters);

/// Likewise for `config/can_bridge.yaml` and BridgeOptions. Whether the options fit together, Bridge says.
can::BridgeOptions bridge_options_from(const ParameterMap& parameters);

/// Both steps for a file; every ConfigError also names the file. Where keys are missing, `defaults` is set to a sentence with
/// them and their values.
Robot read_robot_file(const std::string& path, std::string* defaults = nullptr);
PlannerOptions read_planner_file(const std::string& path, std::string* defaults = nullptr);
TrackOptions read_track_file(const std::string& path, std::string* defaults = nullptr);
SimulatorOptions read_simulator_file(const std::string& path, std::string* defaults = nullptr);
can::BridgeOptions read_bridge_file(const std::string& path, std::string* defaults = nullptr);

}  // namespace fourwis
