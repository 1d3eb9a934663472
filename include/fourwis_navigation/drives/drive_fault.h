#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace fourwis::drives
{

/// Faults of drives and of their bus.
enum class DriveFaultKind
{
  node_silent,     ///< the cable is off: the node neither receives nor sends
  reboot,          ///< power is switched off and on, once
  emergency,       ///< an EMCY and the warning bit, once; `value`: error code
  drive_fault,     ///< fault reaction and fault, once; `value`: error code
  heartbeat_lost,  ///< no heartbeat; everything else works
  wrong_size,      ///< process data lacks one byte
  duplicate_id,    ///< a second node of the same id, not configured, boots and sends
  sdo_abort,       ///< every SDO request is refused; `value`: abort code
  sdo_silent,      ///< no SDO request is answered
  status_frozen,   ///< the content of TPDO1 does not change
  status_missing,  ///< TPDO1 is not sent
  stuck_axis,      ///< the axis does not move
  dead_axis,       ///< no torque: a wheel rolls freely, a steering axis stays
  encoder_jump,    ///< the position jumps once, by `value` counts
  foreign_master,  ///< another master commands the node at 100 Hz; `value`: target
  flood,           ///< the bus is full of frames of eight bytes; `value`: their id
  error_passive,   ///< the controllers report that they are error-passive, once
  bus_off          ///< the controllers report that they are off the bus, once
};

/// The name above, and the fault of a name; nothing for an unknown name.
const char* to_string(DriveFaultKind kind);
std::optional<DriveFaultKind> drive_fault_kind(const std::string& name);

/// A fault of a node during a time. For faults that happen once, only the beginning counts.
struct DriveFault
{
  DriveFaultKind kind = DriveFaultKind::node_silent;
  int node = 0;        ///< node id; ignored for faults of the bus
  double begin = 0.0;  ///< [s] of the drives' clock
  double end = std::numeric_limits<double>::infinity();
  std::int64_t value = 0;
};

}  // namespace fourwis::drives
