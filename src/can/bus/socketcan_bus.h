#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "fourwis_navigation/can/bus/bus.h"
#include "fourwis_navigation/can/bus/file_descriptor.h"

namespace fourwis::can
{

/// An interface of Linux SocketCAN. The system sets its bit rate, restarts it after bus-off and brings it up. A link
/// that was down or gone is noticed with the next frame that is sent or received. Then the socket is closed: the socket
/// of a deleted interface never works again, not even with a new interface of that name.
class SocketCanBus final : public Bus
{
public:
  explicit SocketCanBus(std::string interface);

  BusStatus send(const Frame& frame) override;
  BusStatus receive(Frame& frame) override;
  int descriptor() const override { return socket_.get(); }
  bool recover() override;
  BusCounters counters() const override { return counters_; }
  std::string_view last_error() const override { return error_; }

private:
  void open();
  void go_down(int error);
  BusStatus broken(int error);

  std::string interface_;
  FileDescriptor socket_;  ///< none while down
  std::string error_;
  BusCounters counters_;
  std::uint32_t overflowed_ = 0;  ///< frames that this socket has lost, as the kernel counts them
};

}  // namespace fourwis::can
