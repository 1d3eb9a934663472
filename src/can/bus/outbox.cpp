#include "fourwis_navigation/can/bus/outbox.h"

#include <algorithm>

#include "fourwis_navigation/can/protocol/frame_bits.h"

namespace fourwis::can
{

void Outbox::put(const Frame& frame)
{
  const auto end = frames_.begin() + static_cast<std::ptrdiff_t>(size_);
  const auto waiting = std::find_if(frames_.begin(), end, [&](const Frame& other) { return other.id == frame.id; });
  if (waiting == end) return add(frame);
  *waiting = frame;
  ++replaced_;
}

void Outbox::add(const Frame& frame)
{
  if (size_ < kCapacity)
    frames_[size_++] = frame;
  else
    ++lost_;
}

BusStatus Outbox::flush(Bus& bus)
{
  std::size_t sent = 0;
  BusStatus status = BusStatus::ok;
  while (sent < size_ && status == BusStatus::ok)
  {
    status = bus.send(frames_[sent]);
    if (status == BusStatus::ok)
    {
      ++sent_;
      sent_bits_ += worst_case_bits(frames_[sent]);
    }
    // A frame that can never be sent must not hold up the others.
    if (status == BusStatus::ok || status == BusStatus::failed) ++sent;
  }
  std::move(frames_.begin() + static_cast<std::ptrdiff_t>(sent), frames_.begin() + static_cast<std::ptrdiff_t>(size_),
            frames_.begin());
  size_ -= sent;
  return status;
}

}  // namespace fourwis::can
