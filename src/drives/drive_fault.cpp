#include "fourwis_navigation/drives/drive_fault.h"

namespace fourwis::drives
{

const char* to_string(DriveFaultKind kind)
{
  switch (kind)
  {
    case DriveFaultKind::node_silent: return "node_silent";
    case DriveFaultKind::reboot: return "reboot";
    case DriveFaultKind::emergency: return "emergency";
    case DriveFaultKind::drive_fault: return "drive_fault";
    case DriveFaultKind::heartbeat_lost: return "heartbeat_lost";
    case DriveFaultKind::wrong_size: return "wrong_size";
    case DriveFaultKind::duplicate_id: return "duplicate_id";
    case DriveFaultKind::sdo_abort: return "sdo_abort";
    case DriveFaultKind::sdo_silent: return "sdo_silent";
    case DriveFaultKind::status_frozen: return "status_frozen";
    case DriveFaultKind::status_missing: return "status_missing";
    case DriveFaultKind::stuck_axis: return "stuck_axis";
    case DriveFaultKind::dead_axis: return "dead_axis";
    case DriveFaultKind::encoder_jump: return "encoder_jump";
    case DriveFaultKind::foreign_master: return "foreign_master";
    case DriveFaultKind::flood: return "flood";
    case DriveFaultKind::error_passive: return "error_passive";
    case DriveFaultKind::bus_off: return "bus_off";
  }
  return "unknown";
}

std::optional<DriveFaultKind> drive_fault_kind(const std::string& name)
{
  for (int number = 0; number <= static_cast<int>(DriveFaultKind::bus_off); ++number)
    if (const auto kind = static_cast<DriveFaultKind>(number); name == to_string(kind)) return kind;
  return std::nullopt;
}

}  // namespace fourwis::drives
