#include <linux/can/error.h>

#include "../can/bus/bus_laws.h"
#include "../drives/bridge_fault_cases.h"
#include "candump.h"
#include "vcan_rig.h"

namespace fourwis::can
{
namespace
{

/// Ends of vcan0 for the bridge, for the drives, and for the test.
class VcanEnds
{
protected:
  /// Waits until all frames that were sent have come, unless they were lost with the link: a delay of the kernel must
  /// not count as simulated time.
  void settle()
  {
    const auto sent = [this] { return bridge_end->counters().sent + drives_end->counters().sent; };
    Frame frame;
    while (witness->counters().received + lost < sent())
    {
      const BusStatus status = witness->receive(frame);
      if (status == BusStatus::down) witness->recover();
      pollfd wait{witness->descriptor(), POLLIN, 0};
      const bool nothing = status == BusStatus::would_block && poll(&wait, 1, 1000) == 0;
      if (nothing || status == BusStatus::down) lost = sent() - witness->counters().received;
    }
  }

  VcanRig rig;
  std::unique_ptr<Bus> bridge_end = rig.open(), drives_end = rig.open(), witness = rig.open();
  std::uint64_t lost = 0;
};

/// What candump writes of a command for a driving drive, RPDO1 of nodes 5 to 8: controlword, mode, target velocity.
bool is_driving_command(const std::string& line)
{
  return line.size() == 18 && line.compare(0, 2, "20") == 0 && line[2] >= '5' && line[2] <= '8';
}
bool moves(const std::string& line)
{
  return is_driving_command(line) && line.substr(10) != "00000000";
}
bool is_sync(const std::string& line)
{
  return line == "080#";
}

class BridgeOnVcan : public testing::Test, protected VcanEnds, protected BridgeBench
{
protected:
  BridgeOnVcan() : BridgeBench(*bridge_end, *drives_end, [this](double) { settle(); }) {}

  static long count(const std::vector<std::string>& frames, bool (*is)(const std::string&))
  {
    return std::count_if(frames.begin(), frames.end(), is);
  }
  double distance() const { return drives.pose().x; }

  /// Checks that after an interruption the bridge is ready within a second, and does not move before it is enabled.
  void expect_recovery(Fault name)
  {
    Candump candump;
    EXPECT_LE(wait_for(BridgeStage::ready), 1.0) << cause();
    EXPECT_TRUE(told(name)) << cause();
    const double before = distance();
    pass(0.5);
    EXPECT_EQ(distance(), before);
    const std::vector<std::string> frames = candump.frames();
    EXPECT_GT(count(frames, is_sync), 45);
    EXPECT_EQ(count(frames, moves), 0);
    drive();
  }
};

TEST_F(BridgeOnVcan, StartsTheDrivesAndMovesThemOnlyWhenEnabled)
{
  Candump still;
  command(Mode::ackermann, 0.0, 0.5);
  ASSERT_LT(wait_for(BridgeStage::ready), 5.0) << cause();
  pass(0.5);
  EXPECT_EQ(distance(), 0.0);
  const std::vector<std::string> before = still.frames();
  EXPECT_EQ(count(before, moves), 0);
  for (const char* boot_up : {"701#00", "704#00", "705#00", "708#00"})
    EXPECT_NE(std::find(before.begin(), before.end(), boot_up), before.end()) << boot_up;

  Candump moving;
  drive();
  pass(1.0);
  EXPECT_GT(distance(), 0.5);
  const std::vector<std::string> after = moving.frames();
  EXPECT_GT(count(after, moves), 4 * 100);
}

TEST_F(BridgeOnVcan, RecoversFromALinkThatWasDown)
{
  drive();
  rig.take_down();
  pass(0.5);
  EXPECT_EQ(stage(), BridgeStage::link_down);
  EXPECT_EQ(fastest_wheel(), 0.0) << "the drives stop by themselves";
  rig.bring_up();
  expect_recovery(Fault::link_down);
}

TEST_F(BridgeOnVcan, RecoversFromAnInterfaceThatWasDeleted)
{
  drive();
  rig.remove();
  pass(0.5);
  EXPECT_EQ(stage(), BridgeStage::link_down);
  EXPECT_EQ(fastest_wheel(), 0.0) << "the drives stop by themselves";
  rig.add();
  expect_recovery(Fault::link_down);
}

TEST_F(BridgeOnVcan, RecoversFromBusOff)
{
  drive();
  ASSERT_EQ(witness->send({CAN_ERR_BUSOFF, false, false, true, 8, {}}), BusStatus::ok);
  ASSERT_EQ(witness->send({CAN_ERR_RESTARTED, false, false, true, 8, {}}), BusStatus::ok);
  tick();
  expect_recovery(Fault::bus_off);
}

class FaultsOnVcan : public BridgeOnVcan, public testing::WithParamInterface<FaultCase>
{};

TEST_P(FaultsOnVcan, StopTheBaseInTimeAndHaveTheirName)
{
  expect_stop(*this, GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, FaultsOnVcan, testing::ValuesIn(kFaultCases));

}  // namespace
}  // namespace fourwis::can
