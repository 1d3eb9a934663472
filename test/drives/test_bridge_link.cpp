#include "bridge_fixture.h"

namespace fourwis
{
namespace
{

using can::BridgeStage;
using can::Fault;

/// Faults of the bus itself.
class BridgeLink : public BridgeFixture
{
protected:
  /// To be called when the bus is back. No wheel has been commanded to move since `begin`, the base becomes ready by
  /// itself within a second, and it moves only after it has been enabled.
  void expect_recovery(Fault name, double begin)
  {
    EXPECT_LE(wait_for(BridgeStage::ready), 1.0) << cause();
    EXPECT_TRUE(told(name)) << cause();
    pass(1.0);
    EXPECT_LE(last_motion(), begin);
    EXPECT_EQ(stage(), BridgeStage::ready);
    EXPECT_EQ(fastest_wheel(), 0.0);
  }
};

TEST_F(BridgeLink, DownAndUp)
{
  for (const can::Link how : {can::Link::down, can::Link::gone})
    for (const double pause : {0.005, 0.05, 0.5, 8.0})
    {
      drive();
      const double begin = now();
      end->set_link(how);
      pass(pause);
      end->set_link(can::Link::up);
      expect_recovery(Fault::link_down, begin + 0.02);
    }
}

TEST_F(BridgeLink, BusOff)
{
  for (const double pause : {0.05, 0.5, 8.0})
  {
    drive();
    const double begin = now();
    end->bus_off();
    pass(pause);
    end->restart();
    expect_recovery(Fault::bus_off, begin + 0.002);
  }
}

TEST_F(BridgeLink, DownAgainBeforeTheBaseHasBeenEnabled)
{
  wait_for(BridgeStage::ready);
  for (const double pause : {1.0, 0.2, 1.0})  // ready again; still starting; ready again
  {
    end->set_link(can::Link::down);
    EXPECT_LT(wait_for(BridgeStage::link_down), 0.02);
    pass(0.3);
    end->set_link(can::Link::up);
    pass(pause);
  }
  EXPECT_EQ(stage(), BridgeStage::ready) << cause();
}

TEST_F(BridgeLink, DrivesAreStoppedAsSoonAsItIsBack)
{
  drive();
  end->set_link(can::Link::down);
  wait_for(BridgeStage::link_down);
  end->set_link(can::Link::up);
  wait_for(BridgeStage::listening);
  pass(0.003);
  for (int node = 5; node <= 8; ++node)
    EXPECT_EQ(drives.drive(node).power_state(), drives::PowerState::quick_stop_active) << node;
}

TEST_F(BridgeLink, WhatIsMeasuredIsAsOldAsTheDrivesLastAnswers)
{
  drive();
  EXPECT_GT(bridge.wheels().stamp, now() - 0.025);
  end->set_full(true);
  const double begin = now();
  pass(0.5);
  EXPECT_LE(bridge.wheels().stamp, begin);
}

TEST_F(BridgeLink, WhatIsMeasuredIsAsOldAsTheAnswerOfASilentDrive)
{
  drive();
  drives.inject({drives::DriveFaultKind::node_silent, 6, now()});
  const double begin = now();
  pass(0.5);
  EXPECT_LE(bridge.wheels().stamp, begin);
}

TEST_F(BridgeLink, AQueueThatDoesNotMoveIsAFaultAndNothingOldIsSentWhenItMovesAgain)
{
  drive();
  const double begin = now();
  end->set_full(true);
  pass(0.3);
  EXPECT_TRUE(told(Fault::transmit_timeout)) << cause();
  EXPECT_EQ(stage(), BridgeStage::fault);
  EXPECT_LE(bridge.outbox().size(), 12u);
  EXPECT_EQ(fastest_wheel(), 0.0) << "the drives' own watchdog";
  end->set_full(false);
  pass(1.0);
  EXPECT_LE(last_motion(), begin);
  EXPECT_LT(wait_for([this] { return bridge.clear_faults(now()) == nullptr; }), 4.0) << cause();
  drive();
}

TEST_F(BridgeLink, NotesOfTheControllerStopNothing)
{
  drive();
  can::Frame passive;
  passive.error = true;
  passive.id = 0x004;
  passive.size = 8;
  passive.data[1] = 0x20;
  end->inject(passive);
  passive.data[1] = 0x01;
  end->inject(passive);
  pass(1.0);
  EXPECT_TRUE(told(Fault::error_passive));
  EXPECT_TRUE(told(Fault::receive_overflow));
  EXPECT_EQ(stage(), BridgeStage::enabled);
  EXPECT_GT(now() - last_motion(), -0.02);
}

TEST_F(BridgeLink, WhenTheBridgeIsKilledTheDrivesStopWithin100Ms)
{
  for (int phase = 0; phase < 5; ++phase)
  {
    drive();
    pass(0.013 * phase);
    bridge_alive = false;
    const auto any_enabled = [&] {
      for (int node = 1; node <= 8; ++node)
        if (drives.drive(node).power_state() == drives::PowerState::operation_enabled) return true;
      return false;
    };
    EXPECT_LE(wait_for([&] { return !any_enabled(); }), 0.1 + 1e-9);
    pass(0.5);
    EXPECT_EQ(fastest_wheel(), 0.0);
    bridge_alive = true;  // as if it had hung
    pass(0.5);
    EXPECT_EQ(stage(), BridgeStage::fault);
    EXPECT_EQ(fastest_wheel(), 0.0);
    ASSERT_LT(wait_for([&] { return bridge.clear_faults(now()) == nullptr; }), options.stop_timeout);
  }
}

TEST_F(BridgeLink, ABridgeThatTakesTheKilledOnesPlaceMovesNothingBeforeItIsEnabled)
{
  drive();
  bridge_alive = false;
  pass(0.03);
  can::Bridge second(robot, options);
  can::BridgeConnection second_connection(second, spy);
  const double begin = now();
  const auto ready = [&] {
    if (std::lround(now() * 1e3) % 10 == 0) second_connection.cycle(now());
    return second.report().stage == BridgeStage::ready;
  };
  EXPECT_LT(wait_for(ready), 1.0) << text_of(second.report().cause);
  EXPECT_LE(last_motion(), begin);
  EXPECT_EQ(fastest_wheel(), 0.0);
}

can::BridgeOptions with_a_slow_watchdog()
{
  can::BridgeOptions options;
  options.drive_watchdog = 0.5;
  return options;
}

class BridgeWithASlowWatchdog : public BridgeFixture
{
protected:
  BridgeWithASlowWatchdog() : BridgeFixture(with_a_slow_watchdog()) {}
};

TEST_F(BridgeWithASlowWatchdog, ListensUntilTheDrivesOfAKilledOneHaveStopped)
{
  wait_for(BridgeStage::boot);
  EXPECT_GE(spy.sent.front().time, options.drive_watchdog);
}

/// On a bus of 500 kbit/s with a queue of twelve frames.
class BridgeOnASlowBus : public BridgeFixture
{
protected:
  BridgeOnASlowBus() : BridgeFixture({}, {500000.0, 12, 4096}) {}
};

TEST_F(BridgeOnASlowBus, AFloodThatWinsEveryTimeIsSurvivedByStopping)
{
  drive();
  const double begin = now();
  drives.inject({drives::DriveFaultKind::flood, 0, now(), now() + 1.0, 0x001});
  pass(1.2);
  EXPECT_EQ(stage(), BridgeStage::fault);
  EXPECT_TRUE(told(Fault::transmit_timeout) || told(Fault::feedback_lost)) << cause();
  EXPECT_LE(last_motion() - begin, 0.07);
  EXPECT_EQ(fastest_wheel(), 0.0);
  pass(1.0);
  ASSERT_LT(wait_for([&] { return bridge.clear_faults(now()) == nullptr; }), options.stop_timeout);
  drive();
}

TEST_F(BridgeOnASlowBus, AFloodThatLosesEveryTimeChangesNothing)
{
  drive();
  drives.inject({drives::DriveFaultKind::flood, 0, now(), now() + 2.0, 0x7FF});
  pass(2.0);
  EXPECT_EQ(stage(), BridgeStage::enabled) << cause();
  EXPECT_NEAR(drives.twist().vx, 0.5, 0.01);
}

}  // namespace
}  // namespace fourwis
