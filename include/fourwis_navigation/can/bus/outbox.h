#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::can
{

/// Frames that wait to be sent. A frame that is sent periodically replaces the waiting one with the same identifier, so
/// that only the newest is sent and no queue grows. No allocation.
class Outbox
{
public:
  static constexpr std::size_t kCapacity = 64;

  /// Adds a frame, or replaces the waiting one with the same identifier at its place.
  void put(const Frame& frame);

  /// Adds a frame in any case. Without room it is lost; the sender notices that by the missing answer.
  void add(const Frame& frame);

  void clear() { size_ = 0; }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  const Frame& operator[](std::size_t i) const { return frames_[i]; }

  std::uint64_t sent() const { return sent_; }          ///< frames that the bus has taken
  double sent_bits() const { return sent_bits_; }       ///< bits that they took on the bus, in the worst case
  std::uint64_t replaced() const { return replaced_; }  ///< frames that were replaced by a newer one
  std::uint64_t lost() const { return lost_; }          ///< frames that found no room

  /// Sends as many frames as the bus takes. Returns the status of the first frame that it does not take, `ok` if all
  /// were sent.
  BusStatus flush(Bus& bus);

private:
  std::array<Frame, kCapacity> frames_{};
  std::size_t size_ = 0;
  std::uint64_t sent_ = 0, replaced_ = 0, lost_ = 0;
  double sent_bits_ = 0.0;
};

}  // namespace fourwis::can
