#pragma once

#include <array>

#include "fourwis_navigation/can/bridge/base_protocol.h"
#include "fourwis_navigation/can/protocol/controller_notice.h"

namespace fourwis::can
{

/// What the bridge is doing; drawn in doc/can_bridge.md.
enum class BridgeStage : std::uint8_t
{
  link_down,  ///< no bus
  listening,
  boot,
  identify,
  configure,
  start,
  home,
  ready,  ///< could be enabled
  enabling,
  enabled,   ///< follows commands
  stopping,  ///< comes to rest, then disables the drives
  fault      ///< stopped or stopping; needs ~clear_faults
};

const char* to_string(BridgeStage stage);

/// The state of a bridge, for diagnostics.
struct BridgeReport
{
  BridgeStage stage = BridgeStage::link_down;
  FaultRecord cause;                                 ///< why it does not drive
  std::array<FaultRecord, FaultLog::kKept> history;  ///< newest first
  bool emergency_stop = false;
  bool out_of_operation = true;  ///< no drive follows
  double load = 0.0;             ///< of the bus, 0 to 1
  std::uint64_t replaced = 0;    ///< frames overtaken by newer ones before the bus took them
  std::uint64_t overtaken = 0;   ///< commands that came after newer ones
  ControllerNotice controller;   ///< the last one with a state of the controller in it
  std::array<AxisReport, kAxes> axes;
};

}  // namespace fourwis::can
