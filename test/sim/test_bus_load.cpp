#include <gtest/gtest.h>

#include <cmath>

#include "../support/driven_base.h"
#include "fourwis_navigation/can/memory_bus.h"

namespace fourwis
{
namespace
{

/// Bridge and drives on a bus that is no faster than a real one of 500 kbit/s, which is looked at every millisecond.
class BusLoad : public testing::Test
{
protected:
  static constexpr double kLook = 0.001;

  void pass(double now)
  {
    bus.advance(now);
    can::Frame frame;
    while (witness->receive(frame) == can::BusStatus::ok)
      if (frame.id == 0x80) see_sync(now);
    if (std::abs(std::remainder(now, options.cycle_time)) < 0.1 * kLook) begin_cycle();
  }

  void see_sync(double now)
  {
    ++syncs;
    longest_gap = std::max(longest_gap, now - last_sync);
    last_sync = now;
  }

  /// What was sent in the cycle before must have gone: then no frame waits for longer than a cycle.
  void begin_cycle()
  {
    ++cycles;
    if (master->waiting() > 0 || others->waiting() > 0 || !base.bridge().outbox().empty()) ++overrun;
  }

  const Robot robot;
  const can::BridgeOptions options;
  const SimulatorOptions simulator;
  can::MemoryBus bus{{500e3, 12, 4096}};
  std::unique_ptr<can::MemoryBus::End> master = bus.open(), others = bus.open(), witness = bus.open();
  DrivenBase base{*master, *others, robot, options, simulator, [this](double now) { pass(now); }};
  double last_sync = 0.0, longest_gap = 0.0;
  int cycles = 0, overrun = 0, syncs = 0;
};

TEST_F(BusLoad, InTenMinutesOfDrivingNoFrameGrowsOldAndNoSyncIsMissed)
{
  ASSERT_TRUE(base.become(BaseState::ready, 10.0)) << base.state();
  ASSERT_EQ(base.bridge().enable(base.now()), nullptr);
  ASSERT_TRUE(base.become(BaseState::enabled, 3.0)) << base.state();
  longest_gap = cycles = overrun = syncs = 0;
  for (int tenth = 0; tenth < 6000; ++tenth)
  {
    base.drive(wheel_motion(robot, Mode::ackermann, 0.8, 0.4 * std::sin(base.now())));
    base.advance(0.1);
  }
  EXPECT_EQ(base.bridge().wheels().state, BaseState::enabled) << base.state();
  EXPECT_EQ(cycles, 60000);
  EXPECT_EQ(overrun, 0);
  EXPECT_NEAR(syncs, cycles, 1);
  EXPECT_LT(longest_gap, options.cycle_time + 1.5 * kLook);
  EXPECT_EQ(master->counters().dropped + others->counters().dropped, 0u);
}

}  // namespace
}  // namespace fourwis
