#pragma once

#include "fourwis_navigation/can/bridge/bridge_report.h"
#include "fourwis_navigation/model/wheels.h"

namespace fourwis::can
{

/// The states of a bridge. Within `starting` and `enabling` the protocol has steps of its own.
enum class BridgeState
{
  waiting,   ///< for the bus
  starting,  ///< the drives
  ready,
  enabling,
  enabled,
  stopping,
  fault
};

/// The state for the wheel states that are published.
BaseState base_state(BridgeState state);

/// The stage for diagnostics.
BridgeStage bridge_stage(BridgeState state, StartStep step);

}  // namespace fourwis::can
