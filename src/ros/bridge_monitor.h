#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

#include "fourwis_navigation/can/bridge/bridge_thread.h"

namespace fourwis
{

/// What the bridge said last, for those who look at it now and then and those who wait for something. Any thread.
class BridgeMonitor
{
public:
  void put(const can::BridgeUpdate& update);
  can::BridgeUpdate newest() const;

  /// Waits until the condition holds for what the bridge says from now on; false where it does not in `timeout` [s].
  bool wait_for(const std::function<bool(const can::BridgeUpdate&)>& condition, double timeout);

private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  can::BridgeUpdate newest_;
};

}  // namespace fourwis
