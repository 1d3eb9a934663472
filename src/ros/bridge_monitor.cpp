#include "bridge_monitor.h"

#include <chrono>

#include "fourwis_navigation/can/bus/real_time.h"

namespace fourwis
{

void BridgeMonitor::put(const can::BridgeUpdate& update)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  newest_ = update;
  changed_.notify_all();
}

can::BridgeUpdate BridgeMonitor::newest() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return newest_;
}

bool BridgeMonitor::wait_for(const std::function<bool(const can::BridgeUpdate&)>& condition, double timeout)
{
  const double begin = can::monotonic_now();
  std::unique_lock<std::mutex> lock(mutex_);
  return changed_.wait_for(lock, std::chrono::duration<double>(timeout),
                           [&] { return newest_.time > begin && condition(newest_); });
}

}  // namespace fourwis
