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
  double bit_rate = 0.0;             ///< [bit/s]; 0: a frame arrives when it is sent
  std::size_t transmit_queue = 12;   ///< frames an end may have waiting: as SocketCAN with the smallest send buffer
  std::size_t receive_queue = 4096;  ///< frames that wait to be read, before more are dropped
};

/// A bus within one thread, for tests and simulated time: deterministic, without clock and operating system. With a bit
/// rate each end has a transmit queue; of the frames at their heads the one of the smallest id goes first, and takes
/// the time its bits take. Its ends must not outlive it.
class MemoryBus
{
public:
  class End;

  explicit MemoryBus(const MemoryBusOptions& options = {});
  MemoryBus(const MemoryBus&) = delete;
  MemoryBus& operator=(const MemoryBus&) = delete;

  std::unique_ptr<End> open();

  /// Lets what the bus carries until `now` [s] arrive; frames sent from here on are sent at `now`. Never goes back.
  void advance(double now);

  /// When the frame on the bus arrives [s]; infinite where there is none.
  double next_arrival() const;

private:
  void transmit_next();
  void deliver(const Frame& frame, const End* sender);
  void forget(const End& end);

  MemoryBusOptions options_;
  std::vector<End*> ends_;
  double now_ = 0.0;
  End* sender_ = nullptr;  ///< of the frame on the bus
  double arrival_;         ///< of that frame
};

/// What can become of an interface.
enum class Link
{
  up,
  down,
  gone
};

/// One computer on the bus with its interface, which can be told to break.
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

  /// Frames that wait for the bus, the one on it included.
  std::size_t waiting() const { return to_send_.size(); }

  /// This interface alone; what waits in it is lost when it is not up.
  void set_link(Link link);
  /// Refuses every frame (ENOBUFS).
  void set_full(bool full) { full_ = full; }
  /// This controller leaves the bus: an error frame says so, what is sent is lost, nothing is received. Until
  /// restart(), or the link goes down and up.
  void bus_off();
  void restart();
  /// This end receives `frame`, whoever sent it.
  void inject(const Frame& frame);

private:
  friend class MemoryBus;

  MemoryBus& bus_;
  boost::circular_buffer<Frame> to_send_;
  boost::circular_buffer<Frame> received_;
  BusCounters counters_;
  Link link_ = Link::up;
  bool broken_ = false;    ///< has been down since the last recover()
  bool no_frame_ = false;  ///< what was to be sent last
  bool full_ = false;
  bool bus_off_ = false;
};

}  // namespace fourwis::can
