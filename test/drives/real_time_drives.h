#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "fourwis_navigation/can/bus/bus.h"
#include "fourwis_navigation/can/bus/real_time.h"
#include "fourwis_navigation/drives/fake_drives.h"

namespace fourwis
{

/// Eight fake drives at one end of a bus, which run in real time in a thread of their own.
class RealTimeDrives
{
public:
  /// `priority`: see can::BridgeThread.
  explicit RealTimeDrives(const std::string& bus, int priority = 0)
    : bus_(can::open_bus(bus)),
      drives_(*bus_, Robot(), can::BridgeOptions(), SimulatorOptions()),
      thread_([this, priority] {
        if (priority > 0) can::become_real_time(priority);
        run();
      })
  {}
  ~RealTimeDrives()
  {
    end_ = true;
    thread_.join();
  }

  double forward_speed() const { return forward_speed_; }  ///< of the body [m/s]

private:
  void run()
  {
    using Clock = std::chrono::steady_clock;
    for (Clock::time_point next = Clock::now(); !end_; next += std::chrono::milliseconds(1))
    {
      std::this_thread::sleep_until(next);
      drives_.step();
      forward_speed_ = drives_.twist().vx;
    }
  }

  std::unique_ptr<can::Bus> bus_;
  drives::FakeDrives drives_;
  std::atomic<double> forward_speed_{0.0};
  std::atomic<bool> end_{false};
  std::thread thread_;
};

}  // namespace fourwis
