#include "fourwis_navigation/can/protocol/cia402.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "../../support/fuzz_rounds.h"
#include "frame_bytes.h"

namespace fourwis::can
{
namespace
{

TEST(Cia402, TheStatuswordTellsTheState)
{
  using S = DriveState;
  const std::map<int, S> table = {{0x00, S::not_ready},
                                  {0x20, S::not_ready},
                                  {0x40, S::switch_on_disabled},
                                  {0x60, S::switch_on_disabled},
                                  {0x21, S::ready_to_switch_on},
                                  {0x23, S::switched_on},
                                  {0x27, S::operation_enabled},
                                  {0x07, S::quick_stop_active},
                                  {0x0F, S::fault_reaction},
                                  {0x2F, S::fault_reaction},
                                  {0x08, S::fault},
                                  {0x28, S::fault}};
  for (int word = 0; word <= 0xFFFF; ++word)
  {
    const auto row = table.find(word & 0x6F);
    EXPECT_EQ(drive_state(static_cast<std::uint16_t>(word)), row == table.end() ? S::unknown : row->second) << word;
  }
}

/// The part of CiA 402's state diagram in which controlwords change the state, written independently.
DriveState next(DriveState state, std::uint16_t word)
{
  using S = DriveState;
  const bool voltage = word & 2, no_quick_stop = word & 4, on = word & 1, operation = word & 8;
  switch (state)
  {
    case S::switch_on_disabled: return voltage && no_quick_stop && !on ? S::ready_to_switch_on : state;
    case S::ready_to_switch_on:
      if (!voltage || !no_quick_stop) return S::switch_on_disabled;
      return on ? S::switched_on : state;
    case S::switched_on:
      if (!voltage || !no_quick_stop) return S::switch_on_disabled;
      if (!on) return S::ready_to_switch_on;
      return operation ? S::operation_enabled : state;
    case S::operation_enabled:
      if (!voltage) return S::switch_on_disabled;
      if (!no_quick_stop) return S::quick_stop_active;
      if (!on) return S::ready_to_switch_on;
      return operation ? state : S::switched_on;
    case S::quick_stop_active: return voltage ? state : S::switch_on_disabled;
    default: return state;
  }
}

DriveState after(DriveState state, PowerGoal goal, int steps)
{
  for (int i = 0; i < steps; ++i) state = next(state, controlword(state, goal));
  return state;
}

constexpr DriveState kHealthy[] = {DriveState::switch_on_disabled, DriveState::ready_to_switch_on,
                                   DriveState::switched_on, DriveState::operation_enabled,
                                   DriveState::quick_stop_active};

TEST(Cia402, EveryHealthyDriveReachesItsGoalAndStaysThere)
{
  for (const DriveState state : kHealthy)
    for (int extra = 0; extra < 3; ++extra)
    {
      EXPECT_EQ(after(state, PowerGoal::on, 4 + extra), DriveState::operation_enabled) << to_string(state);
      EXPECT_EQ(after(state, PowerGoal::off, 2 + extra), DriveState::ready_to_switch_on) << to_string(state);
    }
}

TEST(Cia402, KeepingNeverEnables)
{
  for (const DriveState state : kHealthy)
  {
    const bool enabled = state == DriveState::operation_enabled;
    EXPECT_EQ(after(state, PowerGoal::keep, 5) == DriveState::operation_enabled, enabled);
  }
}

TEST(Cia402, QuickStopEndsOperationAtOnce)
{
  EXPECT_EQ(after(DriveState::operation_enabled, PowerGoal::quick_stop, 1), DriveState::quick_stop_active);
  for (const DriveState state : kHealthy)
    EXPECT_NE(after(state, PowerGoal::quick_stop, 1), DriveState::operation_enabled) << to_string(state);
}

TEST(Cia402, OperationIsEnabledFromSwitchedOnOnlyAndFaultsAreNeverReset)
{
  for (int s = 0; s <= static_cast<int>(DriveState::unknown); ++s)
    for (const PowerGoal goal : {PowerGoal::off, PowerGoal::keep, PowerGoal::on, PowerGoal::quick_stop})
    {
      const auto state = static_cast<DriveState>(s);
      const std::uint16_t word = controlword(state, goal);
      EXPECT_EQ(word & control::fault_reset, 0);
      const bool enabled = state == DriveState::operation_enabled, next = state == DriveState::switched_on;
      EXPECT_EQ(word == control::enable_operation,
                (goal == PowerGoal::on && (enabled || next)) || (goal == PowerGoal::keep && enabled));
    }
}

TEST(Cia402, ASetPointIsAnnouncedByARisingEdgeAfterEachAcknowledge)
{
  EXPECT_EQ(set_point_bits(0x0027), 0x30);
  EXPECT_EQ(set_point_bits(0x1027), 0x20);
}

TEST(Cia402, SupportedModesAreCountedFromOne)
{
  EXPECT_TRUE(supports(0x001, OperationMode::profile_position));
  EXPECT_TRUE(supports(0x004, OperationMode::profile_velocity));
  EXPECT_TRUE(supports(0x020, OperationMode::homing));
  EXPECT_TRUE(supports(0x080, OperationMode::cyclic_position));
  EXPECT_TRUE(supports(0x100, OperationMode::cyclic_velocity));
  EXPECT_FALSE(supports(0xFFFFFE7F, OperationMode::cyclic_position));
  EXPECT_FALSE(supports(0xFFFFFFFF, OperationMode::none));
}

TEST(Cia402, CyclicMessagesAreTheBytesOfOurMapping)
{
  EXPECT_EQ(encode_drive_command(1, {0x0F, OperationMode::cyclic_position, -2}),
            frame_of(0x201, {0x0F, 0x00, 0x08, 0xFE, 0xFF, 0xFF, 0xFF}));
  EXPECT_EQ(encode_drive_command(8, {0x013F, OperationMode::cyclic_velocity, 0x01020304}),
            frame_of(0x208, {0x3F, 0x01, 0x09, 0x04, 0x03, 0x02, 0x01}));
  const auto status = decode_drive_status(frame_of(0x181, {0x37, 0x12, 0xFF}));
  ASSERT_TRUE(status);
  EXPECT_EQ(status->statusword, 0x1237);
  EXPECT_EQ(status->mode, -1);
  const auto motion = decode_drive_motion(frame_of(0x288, {0xFE, 0xFF, 0xFF, 0xFF, 4, 3, 2, 1}));
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->position, -2);
  EXPECT_EQ(motion->velocity, 0x01020304);
}

std::vector<int> bytes_of(std::uint64_t value, int size)
{
  std::vector<int> bytes;
  for (int i = 0; i < size; ++i) bytes.push_back(static_cast<int>(value >> (8 * i) & 0xFF));
  return bytes;
}

TEST(Cia402, CommandsThereAndBackAreTheSame)
{
  Random random(5);
  for (int i = 0; i < 20000; ++i)
  {
    const int word = random.whole(0, 0xFFFF), node = random.whole(1, 127);
    const int target = random.whole(-2147483647, 2147483647);
    const Frame frame = encode_drive_command(node, {static_cast<std::uint16_t>(word), OperationMode::homing, target});
    const std::vector<int> bytes(frame.data.begin(), frame.data.begin() + frame.size);
    const std::uint64_t expected = static_cast<std::uint64_t>(word) | 6u << 16 |
                                   static_cast<std::uint64_t>(static_cast<std::uint32_t>(target)) << 24;
    EXPECT_EQ(bytes, bytes_of(expected, 7));
    EXPECT_EQ(frame.id, 0x200u + static_cast<unsigned>(node));
  }
}

TEST(Cia402, DecodersTakeNothingButTheirOwnMessages)
{
  Random random(6);
  int statuses = 0, motions = 0;
  for (int i = 0; i < fuzz_rounds(200000); ++i)
  {
    const Frame frame = i % 2 ? random_frame(random) : random_frame(random, random.chance(0.5) ? 0x181 : 0x281);
    const std::uint32_t base = frame.id & 0x780;
    const bool status = decode_drive_status(frame).has_value(), motion = decode_drive_motion(frame).has_value();
    const bool from_node = is_standard(frame) && (frame.id & 0x7F) != 0;
    EXPECT_EQ(status, from_node && frame.size == 3 && base == 0x180);
    EXPECT_EQ(motion, from_node && frame.size == 8 && base == 0x280);
    statuses += status;
    motions += motion;
  }
  EXPECT_GT(statuses, 0);
  EXPECT_GT(motions, 0);
}

}  // namespace
}  // namespace fourwis::can
