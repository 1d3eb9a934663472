#include <vector>

#include "../can/protocol/frame_bytes.h"
#include "../support/allocations.h"
#include "bridge_fixture.h"

namespace fourwis
{
namespace
{

using can::BridgeOptions;
using can::BridgeStage;
using can::Fault;
using drives::DriveFaultKind;

class BridgeStart : public BridgeFixture
{
protected:
  using BridgeFixture::BridgeFixture;

  void inject(DriveFaultKind kind, int node, std::int64_t value = 0)
  {
    drives.inject({kind, node, now() + 0.001, std::numeric_limits<double>::infinity(), value});
  }

  /// Checks that the start ends in this fault, and that the next one succeeds without its cause.
  void expect_refusal(Fault name)
  {
    EXPECT_LT(wait_for(BridgeStage::fault), options.boot_timeout + 1.0);
    EXPECT_TRUE(told(name)) << cause();
    drives.clear_faults();
    pass(1.0);
    EXPECT_EQ(stage(), BridgeStage::fault) << "it starts by itself";
    ASSERT_LT(wait_for([&] { return bridge.clear_faults(now()) == nullptr; }, 5.0), 5.0);
    EXPECT_LT(wait_for(BridgeStage::ready), 2.0) << cause();
    drive();
  }
};

TEST_F(BridgeStart, GoesThroughItsStagesInOrderAndWaitsToBeEnabled)
{
  std::vector<BridgeStage> stages = {stage()};
  const auto follow = [&] {
    if (stage() != stages.back()) stages.push_back(stage());
    return stage() == BridgeStage::ready;
  };
  EXPECT_LT(wait_for(follow), 1.0);
  EXPECT_EQ(stages, (std::vector<BridgeStage>{BridgeStage::link_down, BridgeStage::listening, BridgeStage::boot,
                                              BridgeStage::identify, BridgeStage::configure, BridgeStage::start,
                                              BridgeStage::ready}))
      << cause();
  pass(1.0);
  EXPECT_EQ(stage(), BridgeStage::ready);
  for (int node = 1; node <= 8; ++node) EXPECT_EQ(drives.drive(node).power_state(), drives::PowerState::ready);
}

TEST_F(BridgeStart, SwitchesTheDrivesOwnWatchdogsOn)
{
  wait_for(BridgeStage::ready);
  for (int node = 1; node <= 8; ++node)
  {
    const drives::ObjectDictionary& objects = drives.drive(node).objects();
    EXPECT_EQ(objects.get(0x1016, 1), 127 << 16 | 100);
    EXPECT_EQ(objects.get(0x1029, 1), 2);
    EXPECT_EQ(objects.get(0x6007), 3);
    EXPECT_EQ(objects.get(0x605A), 2);
    EXPECT_EQ(objects.get(0x1017), 50);
  }
}

TEST_F(BridgeStart, SendsNothingBeforeItHasListened)
{
  wait_for(BridgeStage::boot);
  EXPECT_GE(spy.sent.front().time, 0.1);
}

TEST_F(BridgeStart, ADriveThatDoesNotAppear)
{
  inject(DriveFaultKind::node_silent, 3);
  expect_refusal(Fault::boot_timeout);
}

TEST_F(BridgeStart, ADriveThatDoesNotAnswer)
{
  inject(DriveFaultKind::sdo_silent, 8);
  expect_refusal(Fault::sdo_timeout);
}

TEST_F(BridgeStart, ADriveThatRefuses)
{
  inject(DriveFaultKind::sdo_abort, 5, 0x06040041);
  expect_refusal(Fault::sdo_abort);
}

TEST_F(BridgeStart, ADriveThatIsNeverReady)
{
  inject(DriveFaultKind::status_missing, 2);
  const can::Frame not_ready = can::frame_of(0x182, {0x00, 0x00, 8});
  const auto fails = [&] {
    if (std::lround(now() * 1e3) % 10 == 5) end->inject(not_ready);
    return stage() == BridgeStage::fault;
  };
  EXPECT_LT(wait_for(fails), options.enable_timeout + 1.0);
  EXPECT_TRUE(told(Fault::power_timeout)) << cause();
  EXPECT_EQ(bridge.report().cause.axis, 1);
}

TEST_F(BridgeStart, AnotherMasterCommandsTheDrives)
{
  inject(DriveFaultKind::foreign_master, 2);
  expect_refusal(Fault::foreign_master);
}

TEST_F(BridgeStart, SendsNothingAsLongAsAnotherMasterCommandsTheDrives)
{
  inject(DriveFaultKind::foreign_master, 2);
  EXPECT_LT(wait_for(BridgeStage::fault), 1.0);
  pass(1.0);
  EXPECT_TRUE(spy.sent.empty());
}

TEST_F(BridgeStart, NothingCountsAsMeasuredBeforeEveryDriveHasSpoken)
{
  const auto measured = [this] { return bridge.wheels().stamp != 0.0; };
  EXPECT_LT(wait_for(measured), 1.0);
  for (const can::AxisReport& axis : bridge.report().axes) EXPECT_NE(axis.drive, can::DriveState::unknown);
}

TEST_F(BridgeStart, ATargetFromEarlierMovesNothing)
{
  enable();
  command(Mode::parallel, 0.5, 0.5);
  pass(2.0);
  commands = false;
  pass(2.0);
  const double angle = drives.truth().angle[0];
  enable();
  pass(0.1);
  EXPECT_EQ(fastest_wheel(), 0.0);
  EXPECT_NEAR(drives.truth().angle[0], angle, 1e-3);
}

TEST_F(BridgeStart, AStatuswordThatStaysWhatItIsIsFoundWhenThePowerIsSwitched)
{
  drive();
  inject(DriveFaultKind::status_frozen, 5);
  pass(0.5);
  bridge.disable(now());
  pass(options.stop_timeout + options.enable_timeout + 1.0);
  EXPECT_TRUE(told(Fault::power_timeout)) << cause();
  EXPECT_EQ(bridge.report().cause.axis, 4);
  EXPECT_EQ(fastest_wheel(), 0.0);
}

BridgeOptions with_a_temperature()
{
  BridgeOptions options;
  options.temperature_object = 0x101801;  // any that the drives have: 1018:1, their maker's number
  options.temperature_unit = 0.001;
  return options;
}

class Telemetry : public BridgeStart
{
protected:
  Telemetry() : BridgeStart(with_a_temperature()) {}
};

TEST_F(Telemetry, IsAskedForWhileDriving)
{
  drive();
  pass(2.0);
  for (const can::AxisReport& axis : bridge.report().axes)
  {
    EXPECT_NEAR(axis.voltage, 48.0, 1e-9);
    EXPECT_NEAR(axis.temperature, 1e-3 * drives::DriveOptions().vendor, 1e-9);
  }
  EXPECT_EQ(stage(), BridgeStage::enabled) << cause();
}

BridgeOptions with_other_vendor()
{
  BridgeOptions options;
  options.vendor_id = 1;
  return options;
}

class OtherVendor : public BridgeStart
{
protected:
  OtherVendor() : BridgeStart(with_other_vendor(), BridgeOptions(), {}) {}
};

TEST_F(OtherVendor, IsRefused)
{
  EXPECT_LT(wait_for(BridgeStage::fault), 1.0);
  EXPECT_TRUE(told(Fault::wrong_device)) << cause();
}

BridgeOptions with_profile_modes()
{
  BridgeOptions options;
  options.steering_mode = can::SteeringMode::profile;
  options.driving_mode = can::DrivingMode::profile;
  return options;
}

class ProfileModes : public BridgeStart
{
protected:
  ProfileModes() : BridgeStart(with_profile_modes()) {}
};

TEST_F(ProfileModes, DriveAsWell)
{
  enable();
  command(Mode::parallel, 0.7, -0.4);
  pass(3.0);
  EXPECT_EQ(stage(), BridgeStage::enabled) << cause();
  EXPECT_NEAR(drives.twist().vx, -0.4 * std::cos(0.7), 5e-3);
  EXPECT_NEAR(drives.twist().vy, -0.4 * std::sin(0.7), 5e-3);
}

/// A base with reversed motors, other zero positions and other gears.
BridgeOptions with_odd_axes()
{
  BridgeOptions options;
  options.steering[1].reversed = options.driving[1].reversed = options.driving[3].reversed = true;
  options.steering[0].offset = 0.3;
  options.steering[2].offset = -1.0;
  options.steering[3].gear_ratio = 80.0;
  options.driving[0].counts_per_turn = 4096.0;
  options.driving[2].node = 42;
  return options;
}

class OddAxes : public BridgeStart
{
protected:
  OddAxes() : BridgeStart(with_odd_axes()) {}
};

TEST_F(OddAxes, DriveAsWell)
{
  enable();
  command(Mode::parallel, -0.7, 0.4);
  pass(3.0);
  EXPECT_EQ(stage(), BridgeStage::enabled) << cause();
  EXPECT_NEAR(drives.twist().vx, 0.4 * std::cos(0.7), 5e-3);
  EXPECT_NEAR(drives.twist().vy, -0.4 * std::sin(0.7), 5e-3);
}

BridgeOptions with_fine_encoders()
{
  BridgeOptions options;
  for (can::AxisOptions& axis : options.driving) axis.counts_per_turn = 8388608.0;
  return options;
}

class FineEncoders : public BridgeStart
{
protected:
  FineEncoders() : BridgeStart(with_fine_encoders()) {}
};

TEST_F(FineEncoders, BeginAgainAtTheOtherEndOfTheirRangeWithoutAJump)
{
  drive();
  const double rolled = bridge.report().axes[4].position;
  pass(20.0);  // every 16 m
  EXPECT_EQ(stage(), BridgeStage::enabled) << cause();
  EXPECT_NEAR(bridge.report().axes[4].position - rolled, 10.0, 0.1);
}

BridgeOptions with_homing()
{
  BridgeOptions options;
  options.homing = true;
  options.homing_method = 34;
  return options;
}

class Homing : public BridgeStart
{
protected:
  Homing() : BridgeStart(with_homing()) {}
};

TEST_F(Homing, ComesBeforeTheFirstMotionAndOnlyAfterTheBaseIsEnabled)
{
  ASSERT_LT(wait_for(BridgeStage::ready), 2.0) << cause();
  pass(0.5);
  EXPECT_EQ(stage(), BridgeStage::ready);
  ASSERT_EQ(bridge.enable(now()), nullptr);
  EXPECT_LT(wait_for(BridgeStage::home), 1.0) << cause();
  EXPECT_LT(wait_for(BridgeStage::enabled), 2.0) << cause();
  drive();
}

TEST_F(Homing, ThatDoesNotEndIsAFault)
{
  ASSERT_LT(wait_for(BridgeStage::ready), 2.0) << cause();
  ASSERT_EQ(bridge.enable(now()), nullptr);
  ASSERT_LT(wait_for(BridgeStage::home), 1.0) << cause();
  drives.inject({DriveFaultKind::status_frozen, 2, now()});
  EXPECT_NEAR(wait_for(BridgeStage::fault), options.homing_timeout, 0.1);
  EXPECT_TRUE(told(Fault::homing_failed)) << cause();
}

TEST_F(Homing, OfADriveThatCannotBeSwitchedOnIsNotWaitedFor)
{
  ASSERT_LT(wait_for(BridgeStage::ready), 2.0) << cause();
  inject(DriveFaultKind::status_frozen, 2);
  pass(0.1);
  ASSERT_EQ(bridge.enable(now()), nullptr);
  EXPECT_LT(wait_for(BridgeStage::fault), options.enable_timeout + 0.5);
  EXPECT_TRUE(told(Fault::power_timeout)) << cause();
  EXPECT_EQ(bridge.report().cause.axis, 1);
}

/// The bridge between its construction and its destruction.
class BridgeInTheLoop : public BridgeStart
{
protected:
  BridgeInTheLoop() { spy.sent.reserve(1 << 20); }

  void run_bridge() override
  {
    const long before = allocations;
    BridgeStart::run_bridge();
    allocated += allocations - before;
  }

  long allocated = 0;
};

TEST_F(BridgeInTheLoop, DoesNotAllocate)
{
  drive();
  command(Mode::lateral, 1.5, 0.3);
  pass(2.0);
  inject(DriveFaultKind::drive_fault, 7, 0x2310);
  pass(2.0);
  bridge.clear_faults(now());
  pass(2.0);
  EXPECT_EQ(stage(), BridgeStage::ready) << cause();
  EXPECT_EQ(allocated, 0);
}

TEST(BridgeTwice, TheSameCallsGiveTheSameFrames)
{
  struct Run : BridgeStart
  {
    void TestBody() override
    {
      drive();
      command(Mode::parallel, 0.7, 0.4);
      pass(1.0);
      commands = false;
      pass(1.0);
    }
    using BridgeStart::spy;
  };
  Run first, second;
  first.TestBody();
  second.TestBody();
  ASSERT_EQ(first.spy.sent.size(), second.spy.sent.size());
  for (std::size_t i = 0; i < first.spy.sent.size(); ++i)
  {
    ASSERT_EQ(first.spy.sent[i].frame, second.spy.sent[i].frame);
    ASSERT_EQ(first.spy.sent[i].time, second.spy.sent[i].time);
  }
}

}  // namespace
}  // namespace fourwis
