#pragma once

#include <vector>

#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::drives
{

/// One end of a bus that several nodes share. Frames for which there is no room wait; the smallest id is sent first.
class BusPort
{
public:
  explicit BusPort(can::Bus& bus) : bus_(bus) {}

  /// Whether there was a frame. Without a bus it tries to open it again.
  bool receive(can::Frame& frame);
  void send(const can::Frame& frame) { waiting_.push_back(frame); }
  /// Sends the waiting frames as far as there is room. Without a bus all of them are lost.
  void flush();

private:
  can::Bus& bus_;
  std::vector<can::Frame> waiting_;
};

}  // namespace fourwis::drives
