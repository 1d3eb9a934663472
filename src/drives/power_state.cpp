#include "fourwis_navigation/drives/power_state.h"

namespace fourwis::drives
{
namespace
{

enum class Command
{
  none,
  disable_voltage,
  quick_stop,
  shutdown,
  switch_on,  ///< or disable operation
  enable_operation
};

/// Bits 0 switch on, 1 enable voltage, 2 quick stop (active low), 3 enable operation.
Command command_of(std::uint16_t controlword)
{
  if ((controlword & 0x80) != 0) return Command::none;
  if ((controlword & 0x02) == 0) return Command::disable_voltage;
  if ((controlword & 0x04) == 0) return Command::quick_stop;
  if ((controlword & 0x01) == 0) return Command::shutdown;
  return (controlword & 0x08) == 0 ? Command::switch_on : Command::enable_operation;
}

PowerState from_switch_on_disabled(Command command)
{
  return command == Command::shutdown ? PowerState::ready : PowerState::switch_on_disabled;  // 2
}

PowerState from_ready(Command command)
{
  switch (command)
  {
    case Command::disable_voltage:
    case Command::quick_stop: return PowerState::switch_on_disabled;       // 7
    case Command::switch_on: return PowerState::switched_on;               // 3
    case Command::enable_operation: return PowerState::operation_enabled;  // 3 and 4
    default: return PowerState::ready;
  }
}

PowerState from_switched_on(Command command)
{
  switch (command)
  {
    case Command::disable_voltage:
    case Command::quick_stop: return PowerState::switch_on_disabled;       // 10
    case Command::shutdown: return PowerState::ready;                      // 6
    case Command::enable_operation: return PowerState::operation_enabled;  // 4
    default: return PowerState::switched_on;
  }
}

PowerState from_operation_enabled(Command command)
{
  switch (command)
  {
    case Command::disable_voltage: return PowerState::switch_on_disabled;  // 9
    case Command::quick_stop: return PowerState::quick_stop_active;        // 11
    case Command::shutdown: return PowerState::ready;                      // 8
    case Command::switch_on: return PowerState::switched_on;               // 5
    default: return PowerState::operation_enabled;
  }
}

PowerState from_quick_stop(Command command, bool holds)
{
  if (command == Command::disable_voltage) return PowerState::switch_on_disabled;           // 12
  if (command == Command::enable_operation && holds) return PowerState::operation_enabled;  // 16
  return PowerState::quick_stop_active;
}

}  // namespace

PowerState next_power_state(PowerState state, std::uint16_t controlword, bool fault_reset, bool holds_after_quick_stop)
{
  const Command command = command_of(controlword);
  switch (state)
  {
    case PowerState::switch_on_disabled: return from_switch_on_disabled(command);
    case PowerState::ready: return from_ready(command);
    case PowerState::switched_on: return from_switched_on(command);
    case PowerState::operation_enabled: return from_operation_enabled(command);
    case PowerState::quick_stop_active: return from_quick_stop(command, holds_after_quick_stop);
    case PowerState::fault: return fault_reset ? PowerState::switch_on_disabled : PowerState::fault;  // 15
    default: return state;  // nothing is listened to before the self-test and while a fault is dealt with
  }
}

std::uint16_t power_status(PowerState state)
{
  const std::uint16_t voltage = 0x10;
  switch (state)
  {
    case PowerState::switch_on_disabled: return voltage | 0x40;
    case PowerState::ready: return voltage | 0x21;
    case PowerState::switched_on: return voltage | 0x23;
    case PowerState::operation_enabled: return voltage | 0x27;
    case PowerState::quick_stop_active: return voltage | 0x07;
    case PowerState::fault_reaction: return voltage | 0x0F;
    case PowerState::fault: return voltage | 0x08;
    default: return voltage;
  }
}

const char* to_string(PowerState state)
{
  switch (state)
  {
    case PowerState::switch_on_disabled: return "switch on disabled";
    case PowerState::ready: return "ready to switch on";
    case PowerState::switched_on: return "switched on";
    case PowerState::operation_enabled: return "operation enabled";
    case PowerState::quick_stop_active: return "quick stop active";
    case PowerState::fault_reaction: return "fault reaction active";
    case PowerState::fault: return "fault";
    default: return "not ready to switch on";
  }
}

}  // namespace fourwis::drives
