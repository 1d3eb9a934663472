#pragma once

#include <cstdint>

namespace fourwis::drives
{

/// The power states of CiA 402.
enum class PowerState
{
  not_ready,
  switch_on_disabled,
  ready,
  switched_on,
  operation_enabled,
  quick_stop_active,
  fault_reaction,
  fault
};

/// The next state after a controlword was written (CiA 402-2, transitions 2 to 12, 15 and 16). A rising bit 7 resets a
/// fault. While bit 7 is set, the word commands nothing else. Transition 16 exists only if the quick stop ends in
/// holding (`holds_after_quick_stop`).
PowerState next_power_state(PowerState state, std::uint16_t controlword, bool fault_reset, bool holds_after_quick_stop);

/// Bits 0 to 6 of the statusword, voltage always present.
std::uint16_t power_status(PowerState state);

const char* to_string(PowerState state);

}  // namespace fourwis::drives
