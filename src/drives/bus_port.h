#pragma once

#include <vector>

#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::drives
{

/// Where the controllers of several nodes share one end of a bus: what does not fit at once waits, the smallest id goes
/// first.
class BusPort
{
public:
  explicit BusPort(can::Bus& bus) : bus_(bus) {}

  /// Whether there was a frame. Without a bus tries to find it again.
  bool receive(can::Frame& frame);
  void send(const can::Frame& frame) { waiting_.push_back(frame); }
  /// Hands over what waits, as far as there is room; without a bus all of it is lost.
  void flush();

private:
  can::Bus& bus_;
  std::vector<can::Frame> waiting_;
};

}  // namespace fourwis::drives
