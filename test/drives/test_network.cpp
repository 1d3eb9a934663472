#include <gtest/gtest.h>

#include "drive_bench.h"

namespace fourwis::drives
{
namespace
{

const can::Frame kMasterAlive = raw(0x77F, {0x05});
const can::Frame kHeartbeatLost = raw(0x085, {0x30, 0x81, 0x11, 100, 0, 0, 0, 0});

TEST(Network, SaysHelloOnceBooted)
{
  DriveBench bench;
  bench.pass(0.098);
  EXPECT_EQ(bench.sent, Frames());
  EXPECT_EQ(bench.send(raw(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0})), Frames())
      << "nothing is received while it boots";
  bench.pass(0.002);
  EXPECT_EQ(bench.sent, Frames{raw(0x705, {0x00})});
  EXPECT_EQ(bench.drive.nmt_state(), NmtState::pre_operational);
}

TEST(Network, ObeysTheNmtMaster)
{
  DriveBench bench;
  bench.boot();
  const auto after = [&](int command, int node) {
    bench.send(raw(0x000, {command, node}));
    return bench.drive.nmt_state();
  };
  EXPECT_EQ(after(1, 6), NmtState::pre_operational) << "another node is meant";
  EXPECT_EQ(after(1, 5), NmtState::operational);
  EXPECT_EQ(after(128, 0), NmtState::pre_operational);
  EXPECT_EQ(after(1, 0), NmtState::operational);
  EXPECT_EQ(after(2, 0), NmtState::stopped);
  EXPECT_EQ(bench.send(raw(0x605, {0x40, 0x00, 0x10, 0, 0, 0, 0, 0})), Frames()) << "no SDO while stopped";
  EXPECT_EQ(after(77, 0), NmtState::stopped) << "no such command";
  EXPECT_EQ(after(130, 5), NmtState::initialising);
  bench.boot();
  EXPECT_EQ(bench.drive.nmt_state(), NmtState::pre_operational);
}

TEST(Network, ResetOfTheNodeForgetsEverythingOfCommunicationOnlyThat)
{
  for (int command : {129, 130})
  {
    DriveBench bench;
    bench.boot();
    bench.write(0x1017, 0, 2, 50);
    bench.write(0x6081, 0, 4, 777);
    bench.sent.clear();
    bench.send(raw(0x000, {command, 0}));
    bench.boot();
    EXPECT_EQ(count_of(bench.sent, 0x705), 1) << "boot-up, and no heartbeat any more";
    EXPECT_EQ(bench.read(0x1017), 0u);
    EXPECT_EQ(bench.read(0x6081), command == 129 ? 100000u : 777u);
  }
}

TEST(Network, ProducesItsHeartbeat)
{
  DriveBench bench;
  bench.boot();
  bench.write(0x1017, 0, 2, 50);
  bench.sent.clear();
  bench.pass(0.225);
  EXPECT_EQ(bench.sent, Frames(4, raw(0x705, {0x7F})));
  bench.start();
  bench.sent.clear();
  bench.pass(0.05);
  EXPECT_TRUE(contains(bench.sent, raw(0x705, {0x05})));
}

/// A drive that turns at 10000 counts/s, with its watchdog set up as by the bridge.
class Watchdog : public ::testing::Test
{
protected:
  void SetUp() override
  {
    bench.boot();
    bench.write(0x1016, 1, 4, 0x7F0064);  // node 127, 100 ms
    bench.write(0x1029, 1, 1, 2);
    bench.write(0x6007, 0, 2, 3);
    bench.write(0x605A, 0, 2, 2);
    bench.write(0x6085, 0, 4, 100000);  // 10000 counts/s in 100 ms
    bench.write(0x6060, 0, 1, 9);
    bench.write(0x60FF, 0, 4, 10000);
    bench.start();
    bench.enable();
    bench.step();
    ASSERT_EQ(bench.motor.velocity, 10000);
  }

  DriveBench bench;
};

TEST_F(Watchdog, SleepsUntilItHasHeardTheMaster)
{
  bench.pass(2.0);
  EXPECT_EQ(bench.drive.power_state(), PowerState::operation_enabled);
}

TEST_F(Watchdog, SilenceOfTheMasterIsAQuickStopWithin100Ms)
{
  for (int k = 0; k < 5; ++k)
  {
    bench.send(kMasterAlive);
    bench.pass(0.05);
  }
  ASSERT_EQ(bench.drive.power_state(), PowerState::operation_enabled);
  bench.send(kMasterAlive);
  bench.sent.clear();
  bench.pass(0.099);
  EXPECT_EQ(bench.drive.power_state(), PowerState::operation_enabled);
  bench.step();
  EXPECT_EQ(bench.drive.power_state(), PowerState::quick_stop_active);
  EXPECT_EQ(bench.drive.nmt_state(), NmtState::stopped);
  EXPECT_TRUE(contains(bench.sent, kHeartbeatLost));
  bench.pass(0.05);
  EXPECT_NEAR(bench.motor.velocity, 5000, 101) << "down the ramp";
  bench.pass(0.055);
  EXPECT_EQ(bench.motor.velocity, 0.0);
  EXPECT_EQ(bench.drive.power_state(), PowerState::switch_on_disabled);
}

TEST_F(Watchdog, NoFrameOfTheMasterWakesAStoppedNodeButStart)
{
  bench.send(kMasterAlive);
  bench.pass(0.5);
  bench.send(kMasterAlive);
  for (int word : {0x06, 0x07, 0x0F}) bench.send(raw(0x205, {word, 0x00}));
  EXPECT_EQ(bench.drive.power_state(), PowerState::switch_on_disabled);
  bench.start();
  for (int word : {0x06, 0x07, 0x0F}) bench.send(raw(0x205, {word, 0x00}));
  EXPECT_EQ(bench.drive.power_state(), PowerState::operation_enabled);
}

TEST_F(Watchdog, TheBootUpOfTheMasterAndOtherNodesDoNotFeedIt)
{
  bench.send(kMasterAlive);
  bench.pass(0.05);
  bench.send(raw(0x77F, {0x00}));
  bench.send(raw(0x701, {0x05}));
  bench.send(raw(0x77F, {0x05, 0x00}));
  bench.pass(0.05);
  EXPECT_EQ(bench.drive.power_state(), PowerState::quick_stop_active);
}

TEST_F(Watchdog, ReactsAs6007And1029Say)
{
  const struct
  {
    int connection, behaviour;
    PowerState power;
    NmtState nmt;
  } cases[] = {{0, 0, PowerState::operation_enabled, NmtState::pre_operational},
               {0, 1, PowerState::operation_enabled, NmtState::operational},
               {1, 1, PowerState::fault_reaction, NmtState::operational},
               {2, 1, PowerState::switch_on_disabled, NmtState::operational},
               {3, 2, PowerState::quick_stop_active, NmtState::stopped}};
  for (const auto& row : cases)
  {
    SetUp();
    bench.write(0x6007, 0, 2, row.connection);
    bench.write(0x1029, 1, 1, row.behaviour);
    bench.send(kMasterAlive);
    bench.pass(0.1);
    EXPECT_EQ(bench.drive.power_state(), row.power) << row.connection;
    EXPECT_EQ(bench.drive.nmt_state(), row.nmt) << row.behaviour;
    bench = DriveBench();
  }
}

TEST_F(Watchdog, NmtStopAndResetOfCommunicationAreALostConnectionToo)
{
  for (int command : {2, 130})
  {
    bench.send(raw(0x000, {command, 0}));
    EXPECT_EQ(bench.drive.power_state(), PowerState::quick_stop_active);
    bench = DriveBench();
    SetUp();
  }
}

TEST(Network, AFaultIsAnEmergencyAndIsRemembered)
{
  DriveBench bench;
  bench.boot();
  bench.start();
  bench.sent.clear();
  bench.drive.fail(0x4310);
  bench.step();
  EXPECT_TRUE(contains(bench.sent, raw(0x085, {0x10, 0x43, 0x09, 0, 0, 0, 0, 0})));
  bench.drive.fail(0x2310);
  bench.step();
  EXPECT_EQ(bench.read(0x603F), 0x2310u);
  EXPECT_EQ(bench.read(0x1001), 0x0Bu);
  EXPECT_EQ(bench.read(0x1003, 0), 2u);
  EXPECT_EQ(bench.read(0x1003, 1), 0x2310u);
  EXPECT_EQ(bench.read(0x1003, 2), 0x4310u);
  EXPECT_EQ(bench.send(raw(0x205, {0x80, 0x00})), Frames{raw(0x085, {0, 0, 0, 0, 0, 0, 0, 0})});
  EXPECT_EQ(bench.read(0x1001), 0u);
  EXPECT_EQ(bench.write(0x1003, 0, 1, 0), 0u);
  EXPECT_EQ(bench.read(0x1003, 0), 0u);
  EXPECT_EQ(bench.read(0x1003, 1), 0u);
}

TEST(Network, AWarningIsAnEmergencyWithoutFault)
{
  DriveBench bench;
  bench.boot();
  bench.enable();
  bench.drive.warn(0x4210);
  bench.step();
  EXPECT_TRUE(contains(bench.sent, raw(0x085, {0x10, 0x42, 0x09, 0, 0, 0, 0, 0})));
  EXPECT_EQ(bench.read(0x6041) & 0xEF, 0xA7u);
}

}  // namespace
}  // namespace fourwis::drives
