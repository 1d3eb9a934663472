#pragma once

#include "fourwis_navigation/can/bridge/bridge_report.h"
#include "fourwis_navigation/model/wheels.h"

namespace fourwis::can
{

/// The states of a bridge; within `starting` and `enabling` the protocol has steps of its own.
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

/// What the rest of the world is told of it.
BaseState base_state(BridgeState state);

/// What people are told of it.
BridgeStage bridge_stage(BridgeState state, StartStep step);

}  // namespace fourwis::can
