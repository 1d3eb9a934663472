#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "../../support/random.h"
#include "fourwis_navigation/can/protocol/frame.h"

namespace fourwis::can
{

/// A frame from its identifier and its bytes.
inline Frame frame_of(std::uint32_t id, std::initializer_list<int> bytes)
{
  Frame frame;
  frame.id = id;
  for (const int byte : bytes) frame.data[frame.size++] = static_cast<std::uint8_t>(byte);
  return frame;
}

/// An error frame of a controller, by the classes in its identifier.
inline Frame error_frame(std::uint32_t classes, std::initializer_list<int> bytes)
{
  Frame frame = frame_of(classes, bytes);
  frame.error = true;
  return frame;
}

/// Any frame that a bus could deliver, mostly standard data frames.
inline Frame random_frame(Random& random)
{
  Frame frame;
  frame.extended = random.chance(0.05);
  frame.remote = random.chance(0.05);
  frame.error = random.chance(0.05);
  frame.id = static_cast<std::uint32_t>(random.whole(0, frame.extended ? 0x1FFFFFFF : 0x7FF));
  frame.size = static_cast<std::uint8_t>(random.whole(0, 8));
  for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(random.whole(0, 255));
  return frame;
}

/// A frame with this identifier, of any length and content.
inline Frame random_frame(Random& random, std::uint32_t id)
{
  Frame frame = random_frame(random);
  frame.id = id;
  return frame;
}

inline bool is_standard(const Frame& frame)
{
  return !frame.extended && !frame.remote && !frame.error;
}

}  // namespace fourwis::can
