#pragma once

#include <string>
#include <vector>

namespace fourwis::benchmark
{

struct CanLatency
{
  std::vector<double> microseconds;  ///< for each command, from the callback with it until the kernel has its frames
  std::vector<double> frames;        ///< for each command, so many
  bool real_time = false;            ///< whether the bridge's thread had a real-time priority
};

/// A bridge in a thread of its own drives fake drives in another over the bus `name` (see can::open_bus), 100 cycles a
/// second, while a third thread commands it at 50 Hz as a subscriber's callback does: into the mailbox, and a wake-up.
/// For so many commands. Throws std::runtime_error when the base does not get as far as driving.
CanLatency measure_can_latency(const std::string& name, int commands);

}  // namespace fourwis::benchmark
