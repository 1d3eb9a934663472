#include <cmath>
#include <utility>

#include "bridge_fixture.h"

namespace fourwis
{
namespace
{

using can::BridgeStage;
using can::Fault;

constexpr double kCycle = 0.01;

class BridgeCommands : public BridgeFixture
{};

TEST_F(BridgeCommands, WhatTheWheelsDoIsWhatWasCommanded)
{
  enable();
  command(Mode::parallel, 0.7, -0.4);
  pass(2.0);
  EXPECT_NEAR(drives.twist().vx, -0.4 * std::cos(0.7), 2e-3);
  EXPECT_NEAR(drives.twist().vy, -0.4 * std::sin(0.7), 2e-3);
  const WheelState& wheels = bridge.wheels();
  EXPECT_EQ(wheels.state, BaseState::enabled);
  EXPECT_EQ(wheels.mode, Mode::parallel);
  EXPECT_TRUE(wheels.aligned);
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    EXPECT_NEAR(wheels.motion.angle[i], drives.truth().angle[i], 1e-3);
    EXPECT_NEAR(wheels.motion.speed[i], drives.truth().speed[i], 2e-3);
  }
}

TEST_F(BridgeCommands, WithoutCommandsTheSpeedFramesAreZeroWithin160Ms)
{
  for (int phase = 0; phase < 10; ++phase)  // between the last command and the cycle
  {
    drive();
    pass(0.001 * phase);
    commands = false;
    send(wanted);
    ++wanted.sequence;
    send(wanted);
    const double last = now();
    pass(1.5);
    EXPECT_GE(last_motion() - last, 0.135);
    EXPECT_LT(last_motion() - last, 0.160);
    EXPECT_TRUE(told(Fault::command_timeout));
    EXPECT_EQ(stage(), BridgeStage::ready);
    EXPECT_EQ(fastest_wheel(), 0.0);
  }
}

TEST_F(BridgeCommands, NothingMovesBeforeItIsEnabledAndNothingStartsByItselfAgain)
{
  command(Mode::ackermann, 0.0, 0.5);
  pass(2.0);
  EXPECT_EQ(stage(), BridgeStage::ready);
  EXPECT_EQ(fastest_wheel(), 0.0);
  drive();
  commands = false;
  pass(1.5);
  commands = true;
  pass(1.0);
  EXPECT_EQ(stage(), BridgeStage::ready);
  EXPECT_EQ(fastest_wheel(), 0.0);
  drive();
}

TEST_F(BridgeCommands, NonsenseStopsAtOnce)
{
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), inf, -inf})
  {
    drive();
    WheelCommand broken = wanted;
    ++broken.sequence;
    broken.motion.speed[2] = bad;
    const double begin = now();
    send(broken);
    pass(1.5);
    EXPECT_TRUE(told(Fault::invalid_command));
    EXPECT_LE(last_motion(), begin);
    EXPECT_EQ(stage(), BridgeStage::ready);
  }
}

TEST_F(BridgeCommands, OvertakenOnesDoNotKeepItGoing)
{
  drive();
  commands = false;
  const double last = now();
  for (int i = 0; i < 100; ++i)
  {
    --wanted.sequence;
    send(wanted);
    pass(0.01);
  }
  EXPECT_LT(last_motion() - last, 0.16);
  EXPECT_TRUE(told(Fault::command_timeout));
  EXPECT_GT(bridge.report().overtaken, 0u);
}

TEST_F(BridgeCommands, TheEmergencyStopStopsAtOnceAndForbidsToEnable)
{
  drive();
  const double begin = now();
  bridge.press_emergency_stop(true, now());
  connection.flush(now());
  pass(1.5);
  EXPECT_LE(last_motion(), begin);
  EXPECT_EQ(fastest_wheel(), 0.0);
  EXPECT_TRUE(told(Fault::emergency_stop));
  EXPECT_NE(bridge.enable(now()), nullptr);
  bridge.press_emergency_stop(false, now());
  pass(0.5);
  EXPECT_EQ(stage(), BridgeStage::ready);
  drive();
}

TEST_F(BridgeCommands, DisablingIsAControlledStopWithTheAnglesHeld)
{
  enable();
  command(Mode::parallel, 0.5, 0.8);
  pass(2.0);
  const double begin = now();
  const std::uint32_t last = wanted.sequence;
  bridge.disable(now());
  const double stop = wait_for([&] { return fastest_wheel() < 0.05; });
  EXPECT_NEAR(stop, 0.8 / options.stop_deceleration, 0.1);
  EXPECT_NEAR(last_motion() - begin, 0.8 / options.stop_deceleration, 2.5 * kCycle);
  EXPECT_LT(wait_for(BridgeStage::ready), 1.0);
  EXPECT_NEAR(drives.truth().angle[0], 0.5, 0.01);
  EXPECT_EQ(bridge.wheels().mode, Mode::none);
  EXPECT_EQ(bridge.wheels().sequence, last);
  for (int node = 1; node <= 8; ++node) EXPECT_EQ(drives.drive(node).power_state(), drives::PowerState::ready);
}

TEST_F(BridgeCommands, AnotherModeIsTakenAtStandstillOnly)
{
  drive();
  command(Mode::lateral, 1.5, 0.5);
  bool turned_while_rolling = false, rolled_while_turned_away = false;
  double last_angle = drives.truth().angle[0];
  const auto observe = [&] {
    const WheelMotion wheels = drives.truth();
    const bool rolls = std::abs(wheels.speed[0]) > 0.01, straight = std::abs(wheels.angle[0]) < 0.03;
    const bool there = std::abs(wheels.angle[0] - 1.5) < 0.05;
    const double turned = std::abs(wheels.angle[0] - std::exchange(last_angle, wheels.angle[0]));
    turned_while_rolling |= rolls && turned > 0.1 * robot.wheel_max_rate * 1e-3;
    rolled_while_turned_away |= rolls && !straight && !there;
    return std::abs(drives.twist().vy - 0.5 * std::sin(1.5)) < 0.01;
  };
  EXPECT_LT(wait_for(observe), 2.0);
  EXPECT_FALSE(turned_while_rolling);
  EXPECT_FALSE(rolled_while_turned_away);
}

TEST_F(BridgeCommands, SteeringThatIsStuckIsNamedWhileDrivingAndAtRest)
{
  drive();
  drives.inject({drives::DriveFaultKind::stuck_axis, 3, now()});
  const double begin = now();
  command(Mode::ackermann, 0.3, 0.5);
  pass(2.0);
  EXPECT_TRUE(told(Fault::steering_stuck)) << cause();
  EXPECT_LT(last_motion() - begin, 0.6);
  EXPECT_EQ(stage(), BridgeStage::fault);
}

TEST_F(BridgeCommands, WheelsThatAreNotAlignedInTimeAreAFaultAndNeverDriven)
{
  enable();
  drives.inject({drives::DriveFaultKind::stuck_axis, 3, now()});
  command(Mode::ackermann, 0.1, 0.5);  // nearer than what counts as stuck, further than what counts as aligned
  pass(options.alignment_timeout + 1.0);
  EXPECT_TRUE(told(Fault::alignment_timeout)) << cause();
  EXPECT_LT(last_motion(), 0.0);
}

}  // namespace
}  // namespace fourwis
