#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace fourwis::drives
{

/// What can go wrong with drives and on their bus.
enum class DriveFaultKind
{
  node_silent,     ///< the cable is off: the node neither hears nor is heard
  reboot,          ///< power goes and comes back, once
  emergency,       ///< an EMCY and the warning bit, once; `value`: error code
  drive_fault,     ///< fault reaction and fault, once; `value`: error code
  heartbeat_lost,  ///< no heartbeat, all else works
  wrong_size,      ///< process data one byte short
  duplicate_id,    ///< another node of the same id, not configured, boots and sends
  sdo_abort,       ///< every SDO request is refused; `value`: abort code
  sdo_silent,      ///< no SDO request is answered
  status_frozen,   ///< TPDO1 stays what it is
  status_missing,  ///< TPDO1 is not sent
  stuck_axis,      ///< the axis does not move: a stuck steering
  dead_axis,       ///< no torque: a wheel rolls along, a steering stays
  encoder_jump,    ///< counts differently, once; `value`: by how many counts
  foreign_master,  ///< somebody else commands the node at 100 Hz; `value`: target
  flood,           ///< as many frames of eight bytes as the bus carries; `value`: their id
  error_passive,   ///< the controllers on the bus say they are error-passive, once
  bus_off          ///< and that they are off the bus, once
};

/// The name above, and back; nothing for what is none.
const char* to_string(DriveFaultKind kind);
std::optional<DriveFaultKind> drive_fault_kind(const std::string& name);

/// One of them, at a node, from one time to another. Of those that happen once only the beginning counts.
struct DriveFault
{
  DriveFaultKind kind = DriveFaultKind::node_silent;
  int node = 0;        ///< node id; no matter for the bus's own
  double begin = 0.0;  ///< [s] of the drives' clock
  double end = std::numeric_limits<double>::infinity();
  std::int64_t value = 0;
};

}  // namespace fourwis::drives
