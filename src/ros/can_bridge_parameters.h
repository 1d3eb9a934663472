#pragma once

#include "drive_parameters.h"
#include "fourwis_navigation/can/bridge/bridge_options.h"

namespace fourwis
{

/// The keys of `config/can_bridge_node.yaml`, in the private namespace of can_bridge_node.
struct CanBridgeNodeOptions
{
  BaseFrames frames;
  int real_time_priority = 50;  ///< of the thread that talks to the bus; 0: an ordinary thread
};

/// Everything that can_bridge_node is configured with.
struct CanBridgeParameters
{
  Robot robot;
  can::BridgeOptions bridge;
  CanBridgeNodeOptions node;
};

/// The whole private namespace of the bridge's node: its own keys, `robot/...` and `can_bridge/...`. Throws
/// ConfigError.
CanBridgeParameters can_bridge_parameters_from(const ParameterMap& parameters);

}  // namespace fourwis
