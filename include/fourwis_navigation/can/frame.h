#pragma once

#include <array>
#include <cstdint>

namespace fourwis::can
{

/// A classic CAN frame, as it is on the bus.
struct Frame
{
  std::uint32_t id = 0;     ///< 11 bits, or 29 where `extended`; of an error frame: the error class bits of linux/can/error.h
  bool extended = false;
  bool remote = false;      ///< asks for data and carries none
  bool error = false;       ///< not a frame of the bus but what the controller says of it
  std::uint8_t size = 0;    ///< bytes of data, 0 to 8
  std::array<std::uint8_t, 8> data{};

  friend bool operator==(const Frame& a, const Frame& b)
  {
    if (a.id != b.id || a.extended != b.extended || a.remote != b.remote || a.error != b.error || a.size != b.size)
      return false;
    for (std::uint8_t i = 0; i < a.size; ++i)
      if (a.data[i] != b.data[i]) return false;
    return true;
  }
  friend bool operator!=(const Frame& a, const Frame& b) { return !(a == b); }
};

}  // namespace fourwis::can
