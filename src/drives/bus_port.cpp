#include "bus_port.h"

#include <algorithm>

namespace fourwis::drives
{
namespace
{

/// More frames than this do not wait: those of the largest ids are lost.
constexpr std::size_t kMostWaiting = 256;

}  // namespace

bool BusPort::receive(can::Frame& frame)
{
  const can::BusStatus status = bus_.receive(frame);
  if (status == can::BusStatus::down) bus_.recover();
  return status == can::BusStatus::ok;
}

void BusPort::flush()
{
  const auto by_id = [](const can::Frame& a, const can::Frame& b) { return a.id < b.id; };
  std::stable_sort(waiting_.begin(), waiting_.end(), by_id);
  auto next = waiting_.begin();
  can::BusStatus status = can::BusStatus::ok;
  while (next != waiting_.end() && (status = bus_.send(*next)) != can::BusStatus::would_block &&
         status != can::BusStatus::down)
    ++next;
  waiting_.erase(waiting_.begin(), status == can::BusStatus::down ? waiting_.end() : next);
  if (waiting_.size() > kMostWaiting) waiting_.resize(kMostWaiting);
}

}  // namespace fourwis::drives
