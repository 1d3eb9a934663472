#include "bridge_fixture.h"

namespace fourwis
{
namespace
{

/// On a bus that is no faster than a real one of 500 kbit/s, with a queue of twelve frames at each end.
class BridgeLoad : public BridgeFixture
{
protected:
  BridgeLoad() : BridgeFixture({}, {500e3, 12, 4096}) {}

  void run_bridge() override
  {
    can::Frame frame;
    while (witness->receive(frame) == can::BusStatus::ok)
      if (frame.id == 0x080) see_sync();
    if (std::lround(now() * 1e3) % 10 == 0) begin_cycle();
    BridgeFixture::run_bridge();
  }

  void see_sync()
  {
    ++syncs;
    longest_gap = std::max(longest_gap, now() - last_sync);
    last_sync = now();
  }

  /// The frames of the last cycle must have left by now, so that no frame waits for longer than a cycle.
  void begin_cycle()
  {
    ++cycles;
    if (end->waiting() > 0 || drives_end->waiting() > 0 || !bridge.outbox().empty()) ++overrun;
  }

  std::unique_ptr<can::MemoryBus::End> witness = bus.open();
  double last_sync = 0.0, longest_gap = 0.0;
  int cycles = 0, overrun = 0, syncs = 0;
};

TEST_F(BridgeLoad, InTenMinutesOfDrivingNoFrameGrowsOldAndNoSyncIsMissed)
{
  drive();
  longest_gap = cycles = overrun = syncs = 0;
  for (int tenth = 0; tenth < 6000; ++tenth)
  {
    command(Mode::ackermann, 0.0, 0.6 + 0.2 * std::sin(now()));
    pass(0.1);
  }
  EXPECT_EQ(stage(), can::BridgeStage::enabled) << cause();
  EXPECT_EQ(cycles, 60000);
  EXPECT_EQ(overrun, 0);
  EXPECT_NEAR(syncs, cycles, 1);
  EXPECT_LT(longest_gap, 0.0115) << "looked at every millisecond";
  EXPECT_EQ(end->counters().dropped + drives_end->counters().dropped, 0u);
  EXPECT_LT(bridge.report().load, 0.8);
}

}  // namespace
}  // namespace fourwis
