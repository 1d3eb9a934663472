#include <linux/can/error.h>

#include "../can/bus_laws.h"
#include "../support/driven_base.h"
#include "candump.h"
#include "vcan_rig.h"

namespace fourwis::can
{
namespace
{

/// What candump writes of a command for a driving drive, RPDO1 of nodes 5 to 8: controlword, mode, target velocity.
bool is_driving_command(const std::string& line)
{
  return line.size() == 18 && line.compare(0, 2, "20") == 0 && line[2] >= '5' && line[2] <= '8';
}
bool moves(const std::string& line)
{
  return is_driving_command(line) && line.substr(10) != "00000000";
}

/// Bridge and fake drives with a socket each on vcan0.
class BridgeOnVcan : public testing::Test
{
protected:
  BridgeOnVcan() { simulator.time_step = 0.005; }

  static long count(const std::vector<std::string>& frames, bool (*is)(const std::string&))
  {
    return std::count_if(frames.begin(), frames.end(), is);
  }
  BridgeStage stage() { return base.bridge().report().stage; }
  double distance() const { return base.drives().pose().x; }

  void enable()
  {
    ASSERT_TRUE(base.become(BaseState::ready, 10.0)) << base.state();
    ASSERT_EQ(base.bridge().enable(base.now()), nullptr);
    ASSERT_TRUE(base.become(BaseState::enabled, 3.0)) << base.state();
  }
  void drive_ahead()
  {
    const double before = distance();
    base.drive(wheel_motion(robot, Mode::ackermann, 0.5, 0.0));
    base.advance(2.0);
    EXPECT_GT(distance(), before + 0.5);
  }

  /// After a break that is over: usable within a second, commands or not no motion, until it is enabled.
  void expect_recovery()
  {
    Candump candump;
    EXPECT_TRUE(base.reach(1.0, [&] { return stage() != BridgeStage::link_down; }));
    const bool cleared = base.bridge().clear_faults(base.now()) == nullptr;
    EXPECT_TRUE(base.become(BaseState::ready, 10.0)) << base.state() << (cleared ? "" : ", not cleared");
    const double before = distance();
    base.advance(0.5);
    EXPECT_NEAR(distance(), before, 1e-3);
    const std::vector<std::string> frames = candump.frames();
    EXPECT_GT(count(frames, [](const std::string& line) { return line == "080#"; }), 45);
    EXPECT_EQ(count(frames, moves), 0);
    enable();
    drive_ahead();
  }

  /// The kernel may deliver frames a little later, which must not look like simulated time: waits until all that was sent
  /// has come, unless it was lost with the link.
  void settle()
  {
    const auto sent = [this] { return master->counters().sent + others->counters().sent; };
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
  Robot robot;
  BridgeOptions options;
  SimulatorOptions simulator;
  std::unique_ptr<Bus> master = rig.open(), others = rig.open(), witness = rig.open();
  std::uint64_t lost = 0;
  DrivenBase base{*master, *others, robot, options, simulator, [this](double) { settle(); }};
};

TEST_F(BridgeOnVcan, StartsTheDrivesAndMovesThemOnlyWhenEnabled)
{
  Candump still;
  ASSERT_TRUE(base.become(BaseState::ready, 10.0)) << base.state();
  base.drive(wheel_motion(robot, Mode::ackermann, 0.5, 0.0));
  base.advance(0.5);
  EXPECT_EQ(distance(), 0.0);
  const std::vector<std::string> before = still.frames();
  EXPECT_EQ(count(before, moves), 0);
  for (const char* boot_up : {"701#00", "704#00", "705#00", "708#00"})
    EXPECT_NE(std::find(before.begin(), before.end(), boot_up), before.end()) << boot_up;

  Candump moving;
  enable();
  drive_ahead();
  const std::vector<std::string> after = moving.frames();
  EXPECT_GT(count(after, moves), 4 * 100);
  EXPECT_LE(count(after, is_driving_command), 3 * 4 * 500) << "not more than twice a cycle";
}

TEST_F(BridgeOnVcan, RecoversFromALinkThatWasDown)
{
  enable();
  drive_ahead();
  rig.take_down();
  base.advance(0.5);
  EXPECT_EQ(stage(), BridgeStage::link_down);
  EXPECT_NEAR(base.drives().twist().vx, 0.0, 1e-3) << "the drives stop by themselves";
  rig.bring_up();
  expect_recovery();
}

TEST_F(BridgeOnVcan, RecoversFromAnInterfaceThatWasDeleted)
{
  enable();
  drive_ahead();
  rig.remove();
  base.advance(0.5);
  EXPECT_EQ(stage(), BridgeStage::link_down);
  EXPECT_NEAR(base.drives().twist().vx, 0.0, 1e-3) << "the drives stop by themselves";
  rig.add();
  expect_recovery();
}

TEST_F(BridgeOnVcan, RecoversFromBusOff)
{
  enable();
  drive_ahead();
  const auto controller = rig.open();
  ASSERT_EQ(controller->send({CAN_ERR_BUSOFF, false, false, true, 8, {}}), BusStatus::ok);
  base.advance(0.1);
  EXPECT_EQ(base.bridge().report().history[0].fault, Fault::bus_off) << base.state();
  Candump candump;
  base.advance(0.5);
  EXPECT_EQ(count(candump.frames(), moves), 0);
  EXPECT_NEAR(base.drives().twist().vx, 0.0, 1e-3);
  ASSERT_EQ(controller->send({CAN_ERR_RESTARTED, false, false, true, 8, {}}), BusStatus::ok);
  expect_recovery();
}

}  // namespace
}  // namespace fourwis::can
