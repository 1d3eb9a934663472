#pragma once

#include <cstdint>
#include <functional>

#include "fourwis_navigation/can/protocol/frame.h"

namespace fourwis::drives
{

/// Takes the frames that a slave sends.
using FrameSink = std::function<void(const can::Frame&)>;

/// Function codes of CiA 301: the COB-ID is the function code + the node id.
namespace cob
{
inline constexpr std::uint32_t kNmt = 0x000, kSync = 0x080, kEmergency = 0x080, kSdoReply = 0x580, kSdoRequest = 0x600,
                               kHeartbeat = 0x700, kFirstTransmitPdo = 0x180, kSecondTransmitPdo = 0x280,
                               kFirstReceivePdo = 0x200;
}

inline void put_bytes(can::Frame& frame, std::size_t at, std::uint8_t count, std::uint32_t bytes)
{
  for (std::size_t i = 0; i < count; ++i) frame.data[at + i] = static_cast<std::uint8_t>(bytes >> (8 * i));
}

/// `count` bytes, least significant first.
inline std::uint32_t take_bytes(const can::Frame& frame, std::size_t at, std::uint8_t count)
{
  std::uint32_t bytes = 0;
  for (std::size_t i = 0; i < count; ++i) bytes |= static_cast<std::uint32_t>(frame.data[at + i]) << (8 * i);
  return bytes;
}

inline can::Frame data_frame(std::uint32_t id, std::uint8_t size)
{
  can::Frame frame;
  frame.id = id;
  frame.size = size;
  return frame;
}

/// Whether it is a frame of CANopen: a data frame with an id of 11 bits and at most 8 bytes.
inline bool is_plain(const can::Frame& frame)
{
  return !frame.extended && !frame.remote && !frame.error && frame.size <= 8;
}

}  // namespace fourwis::drives
