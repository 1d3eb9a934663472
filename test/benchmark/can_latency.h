#pragma once

#include <string>

#include "fourwis_navigation/can/bridge/delay_statistics.h"

namespace fourwis::benchmark
{

struct CanLatency
{
  can::DelayStatistics delays;  ///< from command() until the kernel has the frames of all eight drives
  bool real_time = false;       ///< whether the bridge's thread had a real-time priority
};

/// Fake drives and a bridge, each in a thread of its own, on the bus `name` (see can::open_bus), while a third thread
/// commands at 50 Hz as a subscriber's callback does. For so many commands. Throws std::runtime_error when the base does
/// not drive to the end.
CanLatency measure_can_latency(const std::string& name, int commands);

}  // namespace fourwis::benchmark
