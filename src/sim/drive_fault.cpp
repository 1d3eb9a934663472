#include "fourwis_navigation/sim/drive_fault.h"

namespace fourwis::sim
{

const char* to_string(DriveFaultKind kind)
{
  switch (kind)
  {
    case DriveFaultKind::node_silent: return "node silent";
    case DriveFaultKind::reboot: return "reboot";
    case DriveFaultKind::emergency: return "emergency";
    case DriveFaultKind::drive_fault: return "drive fault";
    case DriveFaultKind::heartbeat_lost: return "heartbeat lost";
    case DriveFaultKind::wrong_size: return "wrong size";
    case DriveFaultKind::duplicate_id: return "duplicate id";
    case DriveFaultKind::sdo_abort: return "SDO abort";
    case DriveFaultKind::sdo_silent: return "SDO silent";
    case DriveFaultKind::status_frozen: return "status frozen";
    case DriveFaultKind::status_missing: return "status missing";
    case DriveFaultKind::stuck_axis: return "stuck axis";
    case DriveFaultKind::dead_axis: return "dead axis";
    case DriveFaultKind::encoder_jump: return "encoder jump";
    case DriveFaultKind::foreign_master: return "foreign master";
    case DriveFaultKind::flood: return "flood";
    case DriveFaultKind::error_passive: return "error-passive";
    case DriveFaultKind::bus_off: return "bus-off";
  }
  return "unknown fault";
}

}  // namespace fourwis::sim
