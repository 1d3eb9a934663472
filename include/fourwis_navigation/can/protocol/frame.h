#pragma once

#include <array>
#include <cstdint>

namespace fourwis::can
{

/// A classic CAN frame, as it is on the bus.
struct Frame
{
  std::uint32_t id = 0;  ///< 11 bits, or 29 where `extended`; of an error frame: the class bits of linux/can/error.h
  bool extended = false;
  bool remote = false;    ///< asks for data and carries none
  bool error = false;     ///< a report of the controller, not a frame of the bus
  std::uint8_t size = 0;  ///< bytes of data, 0 to 8
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

/// Whether the frame can be on a bus: at most 8 bytes, an id of 11 or 29 bits; an error frame is neither remote nor
/// extended.
inline bool is_valid(const Frame& frame)
{
  const std::uint32_t largest = frame.extended || frame.error ? 0x1fffffff : 0x7ff;
  return frame.size <= 8 && frame.id <= largest && !(frame.error && (frame.remote || frame.extended));
}

/// The error text of a bus for any other frame.
constexpr char kNoFrame[] =
    "not a frame: more than 8 bytes, an id of too many bits, or an error frame that is remote or extended";

}  // namespace fourwis::can
