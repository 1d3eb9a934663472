#include "ros/bridge_monitor.h"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

#include "fourwis_navigation/can/bus/real_time.h"

namespace fourwis
{
namespace
{

/// What a bridge says again and again while others wait for it.
class TalkingBridge
{
public:
  TalkingBridge(BridgeMonitor& monitor, double time)
    : thread_([this, &monitor, time] {
        can::BridgeUpdate update;
        update.time = time;
        for (; !end_; std::this_thread::yield())
        {
          ++update.cycles;
          monitor.put(update);
        }
      })
  {}
  ~TalkingBridge()
  {
    end_ = true;
    thread_.join();
  }

private:
  std::atomic<bool> end_{false};
  std::thread thread_;
};

bool always(const can::BridgeUpdate&)
{
  return true;
}

TEST(BridgeMonitor, AnUpdateFromBeforeTheWaitIsNoAnswer)
{
  BridgeMonitor monitor;
  const TalkingBridge bridge(monitor, can::monotonic_now());
  EXPECT_FALSE(monitor.wait_for(always, 0.05));
}

TEST(BridgeMonitor, WhatIsSaidAfterwardsIs)
{
  BridgeMonitor monitor;
  const TalkingBridge bridge(monitor, can::monotonic_now() + 1e3);
  EXPECT_TRUE(monitor.wait_for(always, 30.0));
}

}  // namespace
}  // namespace fourwis
