#pragma once

#include <cstdint>

namespace fourwis::drives
{

/// The states of a CANopen node, with the numbers in its heartbeat.
enum class NmtState : std::uint8_t
{
  initialising = 0,
  stopped = 4,
  operational = 5,
  pre_operational = 127
};

}  // namespace fourwis::drives
