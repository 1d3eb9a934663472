#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::can
{

/// Frames that are to be sent. What is sent again and again takes the place of what still waits under the same
/// identifier, so that nothing older than the newest is ever sent and no queue grows. No allocation.
class Outbox
{
public:
  static constexpr std::size_t kCapacity = 64;

  /// The newest of its identifier: replaces the one that waits, keeping its place.
  void put(const Frame& frame);

  /// One more; lost where there is no room, which those who send such frames notice by the answer that does not come.
  void add(const Frame& frame);

  void clear() { size_ = 0; }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  const Frame& operator[](std::size_t i) const { return frames_[i]; }

  std::uint64_t sent() const { return sent_; }          ///< frames that the bus took
  double sent_bits() const { return sent_bits_; }       ///< what they took on the bus, at worst
  std::uint64_t replaced() const { return replaced_; }  ///< frames that were overtaken by a newer one
  std::uint64_t lost() const { return lost_; }          ///< frames that found no room

  /// Sends as much as the bus takes. What the bus says about the first frame that it does not take, `ok` if none is
  /// left.
  BusStatus flush(Bus& bus);

private:
  std::array<Frame, kCapacity> frames_{};
  std::size_t size_ = 0;
  std::uint64_t sent_ = 0, replaced_ = 0, lost_ = 0;
  double sent_bits_ = 0.0;
};

}  // namespace fourwis::can
