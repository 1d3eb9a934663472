#include "fourwis_navigation/drives/fake_drives.h"

#include <gtest/gtest.h>

#include "../support/sentences.h"
#include "drives_fixture.h"
#include "fourwis_navigation/sim/base_simulator.h"
#include "fourwis_navigation/vehicle/wheels.h"

namespace fourwis::drives
{
namespace
{

using FakeDrivesTest = DrivesFixture;

std::int32_t number(const can::Frame& frame, std::size_t at)
{
  return static_cast<std::int32_t>(frame.data[at] | frame.data[at + 1] << 8 | frame.data[at + 2] << 16 |
                                   static_cast<std::uint32_t>(frame.data[at + 3]) << 24);
}

TEST_F(FakeDrivesTest, DoWhatTheFramesSay)
{
  drive_at(1.0);
  const double before = drives.pose().x;
  pass(1.0);
  EXPECT_NEAR(drives.pose().x - before, 1.0, 2e-3);
  EXPECT_NEAR(drives.pose().y, 0.0, 1e-9);
}

TEST_F(FakeDrivesTest, SayWhatTheWheelsDo)
{
  drive_at(0.5);
  steer_to({0.3, 0.3, 0.3, 0.3});
  pass(0.01 - 0.001 * static_cast<double>(ticks % 10));
  const WheelMotion truth = drives.truth();
  const double now = drives.time();
  pass(0.001);
  for (std::uint32_t node = 1; node <= 4; ++node)
    EXPECT_NEAR(number(recorder.of(0x280 + node, now - 0.015).back(), 0), truth.angle[node - 1] * kPerRadian, 2.0);
  for (std::uint32_t node = 5; node <= 8; ++node)
    EXPECT_NEAR(number(recorder.of(0x280 + node, now - 0.015).back(), 4), truth.speed[node - 5] * kPerMetre, 20.0);
}

can::BridgeOptions odd_base()
{
  can::BridgeOptions base;
  base.wheel_radius = 0.2;
  base.steering[0].gear_ratio = 30.0;
  base.steering[1].offset = 0.5;
  base.steering[2].reversed = true;
  base.steering[2].offset = -0.2;
  base.driving[0].counts_per_turn = 4096.0;
  base.driving[3].reversed = true;
  return base;
}

class OddDrives : public DrivesFixture
{
protected:
  OddDrives() : DrivesFixture({}, odd_base()) {}
};

/// A turn of an axis is counts_per_turn * gear_ratio counts.
TEST_F(OddDrives, CountWhatTheirMotorsAndGearsMake)
{
  configure();
  const double steering_turn = 65536.0 * 60.0, driving_turn = 65536.0 * 20.0, turn = 2.0 * M_PI;
  // 1 rad, at 2 rad/s: a jump would be a following error.
  for (int step = 1; step <= 50; ++step)
  {
    const double angle = 0.02 * step;
    master.target[0] = angle * steering_turn / 2.0 / turn;
    master.target[1] = (angle - 0.5) * steering_turn / turn;
    master.target[2] = -(angle + 0.2) * steering_turn / turn;
    master.target[3] = angle * steering_turn / turn;
    if (step == 1) enable();
    pass(0.01);
  }
  const double metre = driving_turn / (turn * 0.2);
  for (std::size_t k = 4; k < 8; ++k) master.target[k] = 0.5 * metre;
  master.target[4] = 0.5 * metre / 16.0;
  master.target[7] = -0.5 * metre;
  pass(0.5);
  for (std::size_t wheel = 0; wheel < 4; ++wheel)
  {
    EXPECT_NEAR(drives.truth().angle[wheel], 1.0, 1e-3) << wheel;
    EXPECT_NEAR(drives.truth().speed[wheel], 0.5, 1e-3) << wheel;
  }
}

TEST_F(FakeDrivesTest, AnswerEverySyncWithTwoFramesEach)
{
  drive_at(0.2);
  recorder.clear();
  pass(1.0);
  EXPECT_EQ(recorder.of(0x080).size(), 100u);
  for (std::uint32_t node = 1; node <= 8; ++node)
  {
    EXPECT_EQ(recorder.of(0x180 + node).size(), 100u);
    EXPECT_EQ(recorder.of(0x280 + node).size(), 100u);
    EXPECT_EQ(recorder.of(0x700 + node).size(), 20u);
    EXPECT_EQ(recorder.of(0x180 + node).back(), raw(0x180 + node, {0x37, 0x12, node <= 4 ? 8 : 9}));
  }
}

/// The same constant command, sent in frames and given to the simulated base, moves both bodies alike.
TEST_F(FakeDrivesTest, AreTheSamePhysicsAsTheSimulatedBase)
{
  const Robot robot;
  configure();
  enable();
  for (Mode mode : {Mode::ackermann, Mode::lateral, Mode::parallel})
  {
    SCOPED_TRACE(to_string(mode));
    const WheelAngles angles = wheel_angles(robot, mode, 0.3);
    BaseSimulator base(robot, SimulatorOptions());
    WheelCommand command;
    command.mode = mode;
    for (std::size_t k = 0; k < 4; ++k)
    {
      command.motion.angle[k] = angles[k];
      command.motion.speed[k] = 0.4 + 0.1 * static_cast<double>(k);
      master.target[k + 4] = 0.0;
    }
    steer_to(angles);
    for (std::size_t k = 4; k < 8; ++k) master.target[k] = command.motion.speed[k - 4] * kPerMetre;
    pass(1.0);
    for (int k = 0; k < 300; ++k)
    {
      base.command(command);
      base.step(0.01);
    }
    EXPECT_NEAR(drives.twist().vx, base.twist().vx, 1e-5);
    EXPECT_NEAR(drives.twist().vy, base.twist().vy, 1e-5);
    EXPECT_NEAR(drives.twist().omega, base.twist().omega, 1e-5);
  }
}

TEST_F(FakeDrivesTest, SilenceOfTheMasterIsAQuickStopWithin100Ms)
{
  drive_at(1.0);
  while (heard.empty() || heard.back().id == 0) pass(0.001);
  pass(0.05 - 0.001 * static_cast<double>(ticks % 50));  // the next heartbeat would be due now
  speaks = false;
  const double silent = drives.time();
  const auto all_stopping = [&] {
    for (int node = 1; node <= 8; ++node)
      if (drives.drive(node).power_state() == PowerState::operation_enabled) return false;
    return true;
  };
  while (!all_stopping() && drives.time() < silent + 1.0) pass(0.001);
  EXPECT_LE(drives.time() - silent, 0.1 + 1e-9);
  pass(0.35);
  EXPECT_NEAR(fastest_wheel(), 0.0, 1e-3) << "5 m/s^2 from 1 m/s";
  for (std::uint32_t node = 1; node <= 8; ++node)
  {
    EXPECT_EQ(recorder.of(0x080 + node).back(), raw(0x080 + node, {0x30, 0x81, 0x11, 100, 0, 0, 0, 0}));
    EXPECT_EQ(drives.drive(static_cast<int>(node)).nmt_state(), NmtState::stopped);
  }
}

TEST_F(FakeDrivesTest, ATargetLeftOverReallyDrives)
{
  master.target[4] = 0.5 * kPerMetre;
  configure();
  enable();
  pass(0.2);
  EXPECT_GT(drives.truth().speed[0], 0.4);
}

TEST_F(FakeDrivesTest, ATargetThatJumpsIsAFollowingError)
{
  configure();
  enable();
  master.target[2] = M_PI_2 * kPerRadian;
  pass(0.15);
  EXPECT_EQ(recorder.of(0x083).back(), raw(0x083, {0x11, 0x86, 0x21, 0, 0, 0, 0, 0}));
}

TEST_F(FakeDrivesTest, WithoutPowerWheelsRollAlongAndSteeringStays)
{
  drive_at(1.0);
  drives.inject({DriveFaultKind::dead_axis, 5, drives.time()});
  pass(0.5);
  EXPECT_NEAR(drives.truth().speed[0], 1.0, 1e-6) << "the others push";
  drives.inject({DriveFaultKind::dead_axis, 1, drives.time()});
  master.target[0] = kPerRadian;
  pass(0.1);
  EXPECT_EQ(drives.truth().angle[0], 0.0);
}

TEST_F(FakeDrivesTest, CanBePlacedAnywhere)
{
  drive_at(1.0);
  drives.place({3.0, 4.0, 1.0});
  EXPECT_EQ(drives.pose().x, 3.0);
  EXPECT_EQ(fastest_wheel(), 0.0);
}

/// The frames of some seconds of driving with faults.
std::vector<RecordedFrame> frames_of_a_run()
{
  class Run : public DrivesFixture
  {
  public:
    void TestBody() override
    {
      drive_at(1.0);
      drives.inject({DriveFaultKind::encoder_jump, 2, drives.time() + 0.1, 1e9, 5000});
      drives.inject({DriveFaultKind::reboot, 7, drives.time() + 0.2});
      pass(1.0);
      frames = recorder.frames();
    }
    std::vector<RecordedFrame> frames;
  };
  Run run;
  run.TestBody();
  return run.frames;
}

TEST(FakeDrivesLaws, TheSameFramesGiveTheSameFrames)
{
  const auto first = frames_of_a_run(), second = frames_of_a_run();
  ASSERT_EQ(first.size(), second.size());
  ASSERT_GT(first.size(), 2000u);
  for (std::size_t k = 0; k < first.size(); ++k)
  {
    ASSERT_EQ(first[k].frame, second[k].frame) << k;
    ASSERT_EQ(first[k].time, second[k].time) << k;
  }
}

TEST(FakeDrivesLaws, OptionsOutOfRangeAreRejectedByName)
{
  can::MemoryBus bus;
  const auto end = bus.open();
  const auto said = [&](const Robot& robot, const can::BridgeOptions& bridge, const SimulatorOptions& simulator) {
    return error_of<std::invalid_argument>([&] { FakeDrives(*end, robot, bridge, simulator); });
  };
  EXPECT_EQ(said({}, {}, {}), "");
  SimulatorOptions simulator;
  simulator.time_step = 0.0;
  EXPECT_TRUE(says(said({}, {}, simulator), "'time_step' is 0"));
  simulator = {};
  simulator.interlock.aligned_angle = 1e-5;
  EXPECT_TRUE(says(said({}, {}, simulator), "'aligned_angle' is 1e-05, expected a number from 0.0001 to 0.5 rad"));
  can::BridgeOptions bridge;
  bridge.driving[0].node = 128;
  EXPECT_TRUE(says(said({}, bridge, {}), "'driving/front_left/node' is 128"));
  Robot robot;
  robot.wheel_max_speed = 0.0;
  EXPECT_TRUE(says(said(robot, {}, {}), "'wheel_max_speed' is 0"));
  DriveOptions drive;
  drive.node = 0;
  EXPECT_TRUE(says(error_of<std::invalid_argument>([&] { FakeDrive{drive}; }), "'node' is 0"));
}

}  // namespace
}  // namespace fourwis::drives
