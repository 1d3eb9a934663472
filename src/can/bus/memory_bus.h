#pragma once

#include <boost/circular_buffer.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::can
{

struct MemoryBusOptions
{
  double bit_rate = 0.0;             ///< [bit/s]; 0: a frame arrives at once
  std::size_t transmit_queue = 12;   ///< frames of an end that may wait: as SocketCAN with the smallest send buffer
  std::size_t receive_queue = 4096;  ///< greatest number of frames that wait to be read; further ones are dropped
};

/// A bus within one thread, for tests and simulated time: deterministic, without clock and operating system. With a bit
/// rate, each end has a transmit queue. Of the frames at the heads of the queues the one with the smallest id is sent
/// first, and each frame takes the time of its bits. The ends must not outlive the bus.
class MemoryBus
{
public:
  class End;

  explicit MemoryBus(const MemoryBusOptions& options = {});
  MemoryBus(const MemoryBus&) = delete;
  MemoryBus& operator=(const MemoryBus&) = delete;

  std::unique_ptr<End> open();

  /// Advances the time to `now` [s], which must not decrease: frames that are complete by then arrive. Frames sent
  /// afterwards are sent at `now`.
  void advance(double now);

  /// When the frame on the bus arrives [s]; infinite if there is none.
  double next_arrival() const;

private:
  void transmit_next();
  void deliver(const Frame& frame, const End* sender);
  void remove(const End& end);

  MemoryBusOptions options_;
  std::vector<End*> ends_;
  double now_ = 0.0;
  End* sender_ = nullptr;  ///< of the frame on the bus
  double arrival_;         ///< of that frame
};

/// The states of an interface.
enum class Link
{
  up,
  down,
  gone
};

/// The interface of one computer on the bus. Tests can make it fail.
class MemoryBus::End final : public Bus
{
public:
  explicit End(MemoryBus& bus);
  ~End() override;

  BusStatus send(const Frame& frame) override;
  BusStatus receive(Frame& frame) override;
  int descriptor() const override { return -1; }
  bool recover() override;
  BusCounters counters() const override { return counters_; }
  std::string_view last_error() const override;

  /// Number of frames that wait for the bus, including the one on it.
  std::size_t waiting() const { return to_send_.size(); }

  /// The state of this interface only. Waiting frames are lost when it is not up.
  void set_link(Link link);
  /// From now on every frame is refused (ENOBUFS).
  void set_full(bool full) { full_ = full; }
  /// This controller leaves the bus. An error frame reports it, sent frames are lost, none is received. It ends with
  /// restart(), or when the link goes down and up.
  void bus_off();
  void restart();
  /// Puts a frame into the receive queue of this end only.
  void inject(const Frame& frame);

private:
  friend class MemoryBus;

  MemoryBus& bus_;
  boost::circular_buffer<Frame> to_send_;
  boost::circular_buffer<Frame> received_;
  BusCounters counters_;
  Link link_ = Link::up;
  bool broken_ = false;    ///< has been down since the last recover()
  bool no_frame_ = false;  ///< the last frame to be sent was not valid
  bool full_ = false;
  bool bus_off_ = false;
};

}  // namespace fourwis::can
