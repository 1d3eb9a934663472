#include <gtest/gtest.h>

#include "drives_fixture.h"

namespace fourwis::drives
{
namespace
{

/// Each fault begins at a node of a base that drives straight ahead at 0.5 m/s. The frames on the bus are checked.
class DriveFaults : public DrivesFixture
{
protected:
  void SetUp() override { drive_at(0.5); }

  void begin(DriveFaultKind kind, int node, std::int64_t value = 0)
  {
    started = drives.time() + 0.001;
    recorder.clear();
    drives.inject({kind, node, started, std::numeric_limits<double>::infinity(), value});
  }
  std::size_t sent(std::uint32_t id) { return recorder.of(id).size(); }
  PowerState power(int node) { return drives.drive(node).power_state(); }

  double started = 0.0;
};

TEST_F(DriveFaults, NodeSilent)
{
  begin(DriveFaultKind::node_silent, 6);
  pass(0.5);
  for (std::uint32_t id : {0x186u, 0x286u, 0x706u, 0x086u}) EXPECT_EQ(sent(id), 0u);
  EXPECT_GT(sent(0x185), 40u);
  EXPECT_EQ(power(6), PowerState::switch_on_disabled) << "it does not hear the master either";
  EXPECT_EQ(power(5), PowerState::operation_enabled);
  drives.clear_faults();
  pass(0.1);
  EXPECT_EQ(recorder.of(0x706).back(), raw(0x706, {0x04}));
}

TEST_F(DriveFaults, Reboot)
{
  begin(DriveFaultKind::reboot, 6);
  pass(0.5);
  EXPECT_EQ(recorder.of(0x706), Frames{raw(0x706, {0x00})});
  EXPECT_EQ(sent(0x186), 0u);
  EXPECT_EQ(power(6), PowerState::switch_on_disabled);
}

TEST_F(DriveFaults, Emergency)
{
  begin(DriveFaultKind::emergency, 7, 0x4210);
  pass(0.2);
  EXPECT_EQ(recorder.of(0x087), Frames{raw(0x087, {0x10, 0x42, 0x09, 0, 0, 0, 0, 0})});
  EXPECT_EQ(recorder.of(0x187).back(), raw(0x187, {0xB7, 0x12, 0x09}));
}

TEST_F(DriveFaults, DriveFault)
{
  begin(DriveFaultKind::drive_fault, 7, 0x2310);
  pass(0.5);
  EXPECT_EQ(recorder.of(0x087), Frames{raw(0x087, {0x10, 0x23, 0x03, 0, 0, 0, 0, 0})});
  EXPECT_EQ(recorder.of(0x187).back(), raw(0x187, {0x18, 0x02, 0x09}));
}

TEST_F(DriveFaults, HeartbeatLost)
{
  begin(DriveFaultKind::heartbeat_lost, 3);
  pass(0.5);
  EXPECT_EQ(sent(0x703), 0u);
  EXPECT_GT(sent(0x183), 40u);
}

TEST_F(DriveFaults, WrongSize)
{
  begin(DriveFaultKind::wrong_size, 3);
  pass(0.1);
  EXPECT_EQ(recorder.of(0x183).back(), raw(0x183, {0x37, 0x12}));
  EXPECT_EQ(recorder.of(0x283).back().size, 7);
  EXPECT_EQ(recorder.of(0x703).back().size, 1) << "process data only";
}

TEST_F(DriveFaults, DuplicateId)
{
  begin(DriveFaultKind::duplicate_id, 4);
  pass(0.1);
  const Frames heartbeats = recorder.of(0x704), statuses = recorder.of(0x184);
  EXPECT_TRUE(contains(heartbeats, raw(0x704, {0x00})));
  EXPECT_TRUE(contains(heartbeats, raw(0x704, {0x05})));
  EXPECT_TRUE(contains(statuses, raw(0x184, {0x50, 0x02, 0x00})));
  EXPECT_TRUE(contains(statuses, raw(0x184, {0x37, 0x12, 0x08})));
}

TEST_F(DriveFaults, SdoAbort)
{
  for (const std::uint32_t code : {0x05030000u, 0x05040000u, 0x08000020u})
  {
    drives.clear_faults();
    begin(DriveFaultKind::sdo_abort, 1, code);
    pass(0.002);
    master.end().send(raw(0x601, {0x40, 0x41, 0x60, 0, 0, 0, 0, 0}));
    pass(0.002);
    const auto byte = [code](int k) { return static_cast<int>(code >> 8 * k & 0xFF); };
    EXPECT_EQ(recorder.of(0x581), Frames{raw(0x581, {0x80, 0x41, 0x60, 0, byte(0), byte(1), byte(2), byte(3)})});
  }
}

TEST_F(DriveFaults, SdoSilent)
{
  begin(DriveFaultKind::sdo_silent, 1);
  pass(0.002);
  master.end().send(raw(0x601, {0x40, 0x41, 0x60, 0, 0, 0, 0, 0}));
  pass(0.05);
  EXPECT_EQ(sent(0x581), 0u);
  EXPECT_GT(sent(0x181), 3u);
}

TEST_F(DriveFaults, StatusFrozen)
{
  begin(DriveFaultKind::status_frozen, 5);
  pass(0.01);
  controlword = 0x06;
  pass(0.1);
  EXPECT_EQ(recorder.of(0x185).back(), raw(0x185, {0x37, 0x12, 0x09}));
  EXPECT_EQ(power(5), PowerState::ready);
}

TEST_F(DriveFaults, StatusMissing)
{
  begin(DriveFaultKind::status_missing, 5);
  pass(0.1);
  EXPECT_EQ(sent(0x185), 0u);
  EXPECT_GT(sent(0x285), 5u);
}

TEST_F(DriveFaults, StuckSteeringAndStuckWheel)
{
  begin(DriveFaultKind::stuck_axis, 1);
  master.target[0] = 0.1 * kPerRadian;
  pass(0.2);
  EXPECT_EQ(drives.truth().angle[0], 0.0);
  drives.inject({DriveFaultKind::stuck_axis, 5, drives.time()});
  pass(0.3);
  EXPECT_NEAR(drives.truth().speed[0], 0.0, 1e-3);
}

TEST_F(DriveFaults, EncoderJump)
{
  begin(DriveFaultKind::encoder_jump, 2, 30000);
  pass(0.3);
  EXPECT_NEAR(drives.truth().angle[1], -30000 / kPerRadian, 1e-4) << "the drive turns the wheel back by what jumped";
}

TEST_F(DriveFaults, ForeignMaster)
{
  begin(DriveFaultKind::foreign_master, 8, static_cast<std::int64_t>(1.5 * kPerMetre));
  pass(0.2);
  EXPECT_GT(sent(0x208), 35u) << "from two";
  EXPECT_TRUE(contains(recorder.of(0x208), raw(0x208, {0x0F, 0x00, 0x09, 0x19, 0xBF, 0x2F, 0x00})));
}

TEST_F(DriveFaults, ErrorFrames)
{
  begin(DriveFaultKind::error_passive, 0);
  drives.inject({DriveFaultKind::bus_off, 0, started + 0.01});
  pass(0.1);
  Frames errors;
  for (const RecordedFrame& recorded : recorder.frames())
    if (recorded.frame.error) errors.push_back(recorded.frame);
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0].id, 0x04u);
  EXPECT_EQ(errors[0].data[1], 0x30);
  EXPECT_EQ(errors[1].id, 0x40u);
}

TEST_F(DriveFaults, EndWhenTheyShould)
{
  drives.inject({DriveFaultKind::heartbeat_lost, 3, drives.time() + 0.1, drives.time() + 0.3});
  const double begin = drives.time();
  pass(0.5);
  EXPECT_EQ(recorder.of(0x703, begin).size(), 6u);
}

TEST_F(DriveFaults, NeedANodeThatExists)
{
  EXPECT_THROW(drives.inject({DriveFaultKind::reboot, 9, 0.0}), std::out_of_range);
  EXPECT_NO_THROW(drives.inject({DriveFaultKind::bus_off, 0, 0.0}));
}

TEST(DriveFaultNames, LeadBackToTheirFault)
{
  for (int number = 0; number <= static_cast<int>(DriveFaultKind::bus_off); ++number)
  {
    const auto kind = static_cast<DriveFaultKind>(number);
    EXPECT_EQ(drive_fault_kind(to_string(kind)), kind) << to_string(kind);
  }
  EXPECT_STREQ(to_string(DriveFaultKind::encoder_jump), "encoder_jump");
  EXPECT_EQ(drive_fault_kind("unknown"), std::nullopt);
}

/// The same on a bus that carries 500 kbit/s.
class SlowBus : public DrivesFixture
{
protected:
  SlowBus() : DrivesFixture({500000.0, 12, 4096}) {}
};

TEST_F(SlowBus, CarriesEightDrivesAt100Hz)
{
  drive_at(0.5);
  recorder.clear();
  pass(1.0);
  EXPECT_EQ(recorder.of(0x080).size(), 100u);
  for (std::uint32_t id = 0x181; id <= 0x188; ++id) EXPECT_NEAR(static_cast<double>(recorder.of(id).size()), 100, 1);
}

TEST_F(SlowBus, AFloodOfTheLeastIdLetsEverythingThrough)
{
  drive_at(0.5);
  drives.inject({DriveFaultKind::flood, 0, drives.time(), drives.time() + 1.0, 0x7FF});
  recorder.clear();
  pass(1.0);
  EXPECT_NEAR(static_cast<double>(recorder.of(0x080).size()), 100, 1);
  EXPECT_GT(recorder.of(0x7FF).size(), 1000u);
  for (int node = 1; node <= 8; ++node) EXPECT_EQ(drives.drive(node).power_state(), PowerState::operation_enabled);
}

TEST_F(SlowBus, AFloodOfTheFirstIdStarvesTheMasterAndTheDrivesStop)
{
  drive_at(0.5);
  drives.inject({DriveFaultKind::flood, 0, drives.time(), drives.time() + 1.0, 0x001});
  pass(0.6);
  EXPECT_NEAR(fastest_wheel(), 0.0, 1e-3);
  for (int node = 1; node <= 8; ++node) EXPECT_EQ(drives.drive(node).power_state(), PowerState::switch_on_disabled);
}

}  // namespace
}  // namespace fourwis::drives
