#include "fourwis_navigation/can/protocol/cia402.h"

#include "bytes.h"
#include "fourwis_navigation/can/protocol/cia301.h"

namespace fourwis::can
{
namespace
{

std::uint16_t controlword_to_switch_on(DriveState state)
{
  switch (state)
  {
    case DriveState::switch_on_disabled: return control::shutdown;
    case DriveState::ready_to_switch_on: return control::switch_on;
    case DriveState::switched_on:
    case DriveState::operation_enabled: return control::enable_operation;
    default: return control::disable_voltage;
  }
}

std::uint16_t controlword_to_switch_off(DriveState state)
{
  switch (state)
  {
    case DriveState::switch_on_disabled:
    case DriveState::ready_to_switch_on:
    case DriveState::switched_on:
    case DriveState::operation_enabled: return control::shutdown;
    default: return control::disable_voltage;
  }
}

}  // namespace

const char* to_string(DriveState state)
{
  switch (state)
  {
    case DriveState::not_ready: return "not ready";
    case DriveState::switch_on_disabled: return "switch-on disabled";
    case DriveState::ready_to_switch_on: return "ready to switch on";
    case DriveState::switched_on: return "switched on";
    case DriveState::operation_enabled: return "operation enabled";
    case DriveState::quick_stop_active: return "quick stop active";
    case DriveState::fault_reaction: return "fault reaction";
    case DriveState::fault: return "fault";
    case DriveState::unknown: break;
  }
  return "unknown";
}

DriveState drive_state(std::uint16_t statusword)
{
  switch (statusword & 0x6F)
  {
    case 0x00:
    case 0x20: return DriveState::not_ready;
    case 0x40:
    case 0x60: return DriveState::switch_on_disabled;
    case 0x21: return DriveState::ready_to_switch_on;
    case 0x23: return DriveState::switched_on;
    case 0x27: return DriveState::operation_enabled;
    case 0x07: return DriveState::quick_stop_active;
    case 0x0F:
    case 0x2F: return DriveState::fault_reaction;
    case 0x08:
    case 0x28: return DriveState::fault;
    default: return DriveState::unknown;
  }
}

std::uint16_t controlword(DriveState state, PowerGoal goal)
{
  switch (goal)
  {
    case PowerGoal::on: return controlword_to_switch_on(state);
    case PowerGoal::off: return controlword_to_switch_off(state);
    case PowerGoal::keep:
      return state == DriveState::operation_enabled ? control::enable_operation : controlword_to_switch_off(state);
    case PowerGoal::quick_stop: return control::quick_stop;
  }
  return control::disable_voltage;
}

std::uint16_t set_point_bits(std::uint16_t statusword)
{
  const bool acknowledged = statusword & status_bit::set_point_acknowledge;
  return control::change_immediately | (acknowledged ? 0 : control::new_set_point);
}

bool supports(std::uint32_t supported_modes, OperationMode mode)
{
  return mode != OperationMode::none && (supported_modes >> (static_cast<int>(mode) - 1) & 1u) != 0;
}

Frame encode_drive_command(int node, const DriveCommand& command)
{
  Frame frame;
  frame.id = cob_id(Service::rpdo1, node);
  frame.size = 7;
  std::uint8_t* to = put_little_endian(command.controlword, frame.data.data());
  to = put_little_endian(static_cast<std::int8_t>(command.mode), to);
  put_little_endian(command.target, to);
  return frame;
}

std::optional<DriveStatus> decode_drive_status(const Frame& frame)
{
  if (frame.size != 3 || address_of(frame).service != Service::tpdo1) return std::nullopt;
  const std::uint8_t* from = frame.data.data();
  return DriveStatus{get_little_endian<std::uint16_t>(from), get_little_endian<std::int8_t>(from + 2)};
}

std::optional<DriveMotion> decode_drive_motion(const Frame& frame)
{
  if (frame.size != 8 || address_of(frame).service != Service::tpdo2) return std::nullopt;
  const std::uint8_t* from = frame.data.data();
  return DriveMotion{get_little_endian<std::int32_t>(from), get_little_endian<std::int32_t>(from + 4)};
}

}  // namespace fourwis::can
