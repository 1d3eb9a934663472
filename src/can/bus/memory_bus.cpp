#include "memory_bus.h"

#include <linux/can/error.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "fourwis_navigation/can/protocol/frame_bits.h"

namespace fourwis::can
{
namespace
{

constexpr double kNever = std::numeric_limits<double>::infinity();

Frame error_frame(std::uint32_t error_class)
{
  Frame frame;
  frame.id = error_class;
  frame.error = true;
  frame.size = CAN_ERR_DLC;
  return frame;
}

/// The priority in arbitration: the smaller id first, and an 11-bit id before a 29-bit id that begins with it.
std::uint64_t rank(const Frame& frame)
{
  return frame.extended ? 2 * std::uint64_t{frame.id} + 1 : std::uint64_t{frame.id} << 19;
}

}  // namespace

MemoryBus::MemoryBus(const MemoryBusOptions& options) : options_(options), arrival_(kNever)
{
  if (!(options.bit_rate >= 0.0) || options.transmit_queue == 0 || options.receive_queue == 0)
    throw std::invalid_argument("MemoryBus: bit_rate must be >= 0 and the queues hold at least one frame");
}

std::unique_ptr<MemoryBus::End> MemoryBus::open()
{
  return std::make_unique<End>(*this);
}

void MemoryBus::advance(double now)
{
  if (!(now >= now_)) throw std::invalid_argument("MemoryBus: time goes back");
  while (arrival_ <= now)
  {
    now_ = arrival_;
    const Frame frame = sender_->to_send_.front();
    sender_->to_send_.pop_front();
    deliver(frame, sender_);
    transmit_next();
  }
  now_ = now;
}

double MemoryBus::next_arrival() const
{
  return arrival_;
}

/// Arbitration: the frame of the lowest rank wins; of equal ranks, that of the end that was opened first.
void MemoryBus::transmit_next()
{
  sender_ = nullptr;
  for (End* end : ends_)
    if (!end->to_send_.empty() && (sender_ == nullptr || rank(end->to_send_.front()) < rank(sender_->to_send_.front())))
      sender_ = end;
  arrival_ = kNever;
  if (sender_ != nullptr) arrival_ = now_ + worst_case_bits(sender_->to_send_.front()) / options_.bit_rate;
}

void MemoryBus::deliver(const Frame& frame, const End* sender)
{
  for (End* end : ends_)
    if (end != sender && end->link_ == Link::up && !end->bus_off_) end->inject(frame);
}

/// Breaks off the frame that `end` was sending.
void MemoryBus::remove(const End& end)
{
  if (sender_ == &end) transmit_next();
}

MemoryBus::End::End(MemoryBus& bus)
  : bus_(bus),
    to_send_(bus.options_.transmit_queue),
    received_(bus.options_.receive_queue)
{
  bus_.ends_.push_back(this);
}

MemoryBus::End::~End()
{
  bus_.ends_.erase(std::find(bus_.ends_.begin(), bus_.ends_.end(), this));
  bus_.remove(*this);
}

BusStatus MemoryBus::End::send(const Frame& frame)
{
  if (broken_) return BusStatus::down;
  no_frame_ = !is_valid(frame);
  if (no_frame_) return BusStatus::failed;
  if (full_ || to_send_.full())
  {
    ++counters_.refused;
    return BusStatus::would_block;
  }
  ++counters_.sent;
  if (bus_off_) return BusStatus::ok;
  if (bus_.options_.bit_rate == 0.0)
  {
    bus_.deliver(frame, this);
    return BusStatus::ok;
  }
  to_send_.push_back(frame);
  if (bus_.sender_ == nullptr) bus_.transmit_next();
  return BusStatus::ok;
}

BusStatus MemoryBus::End::receive(Frame& frame)
{
  if (broken_) return BusStatus::down;
  if (received_.empty()) return BusStatus::would_block;
  frame = received_.front();
  received_.pop_front();
  ++counters_.received;
  return BusStatus::ok;
}

bool MemoryBus::End::recover()
{
  if (link_ != Link::up) return false;
  if (broken_) received_.clear();
  broken_ = false;
  return true;
}

std::string_view MemoryBus::End::last_error() const
{
  if (link_ == Link::down) return "the link is down";
  if (link_ == Link::gone) return "the interface is gone";
  if (broken_) return "the link was down";
  return no_frame_ ? kNoFrame : "";
}

void MemoryBus::End::set_link(Link link)
{
  link_ = link;
  if (link == Link::up) return;
  broken_ = true;
  bus_off_ = false;
  to_send_.clear();
  bus_.remove(*this);
}

void MemoryBus::End::bus_off()
{
  bus_off_ = true;
  to_send_.clear();
  bus_.remove(*this);
  inject(error_frame(CAN_ERR_BUSOFF));
}

void MemoryBus::End::restart()
{
  if (!bus_off_) return;
  bus_off_ = false;
  inject(error_frame(CAN_ERR_RESTARTED));
}

void MemoryBus::End::inject(const Frame& frame)
{
  if (received_.full())
    ++counters_.dropped;
  else
    received_.push_back(frame);
}

}  // namespace fourwis::can
