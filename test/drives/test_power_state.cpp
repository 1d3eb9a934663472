#include "fourwis_navigation/drives/power_state.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "drive_bench.h"

namespace fourwis::drives
{
namespace
{

constexpr std::array<PowerState, 8> kStates = {
    PowerState::not_ready,         PowerState::switch_on_disabled, PowerState::ready,          PowerState::switched_on,
    PowerState::operation_enabled, PowerState::quick_stop_active,  PowerState::fault_reaction, PowerState::fault};

/// One letter for each state, in their order: Not ready, switch on Disabled, Ready, Switched on, Enabled, Quick stop,
/// fault reaction (A), Fault.
constexpr char kLetters[] = "NDRSEQAF";

/// The next state for each value of bits 3 to 0 with bit 7 clear, from the drawing of CiA 402-2; a column for each
/// value.
///                            0   1   2   3   4   5   6   7   8   9   A   B   C   D   E   F
constexpr char kTable[8][17] = {"NNNNNNNNNNNNNNNN",   // not ready
                                "DDDDDDRDDDDDDDRD",   // switch on disabled: only shutdown
                                "DDDDDDRSDDDDDDRE",   // ready
                                "DDDDDDRSDDDDDDRE",   // switched on
                                "DDQQDDRSDDQQDDRE",   // operation enabled
                                "DDQQDDQQDDQQDDQE",   // quick stop active that holds
                                "AAAAAAAAAAAAAAAA",   // fault reaction
                                "FFFFFFFFFFFFFFFF"};  // fault

PowerState wanted(std::size_t from, unsigned word, bool reset, bool holds)
{
  if (kStates[from] == PowerState::fault && reset) return PowerState::switch_on_disabled;
  if ((word & 0x80) != 0) return kStates[from];
  if (kStates[from] == PowerState::quick_stop_active && !holds && (word & 0x0F) == 0x0F) return kStates[from];
  return kStates[static_cast<std::size_t>(std::strchr(kLetters, kTable[from][word & 0x0F]) - kLetters)];
}

TEST(PowerState, FollowsTheWholeTransitionTable)
{
  for (std::size_t from = 0; from < kStates.size(); ++from)
    for (unsigned word = 0; word <= 0xFFFF; ++word)
      for (bool holds : {false, true})
      {
        const bool reset = (word & 0x80) != 0 && (word & 0x400) == 0;  // rising or standing
        ASSERT_EQ(next_power_state(kStates[from], static_cast<std::uint16_t>(word), reset, holds),
                  wanted(from, word, reset, holds))
            << to_string(kStates[from]) << ", word " << std::hex << word << (holds ? ", holds" : "");
      }
}

TEST(PowerState, HasTheBitsOfTheStandard)
{
  const std::array<int, 8> bits = {0x00, 0x40, 0x21, 0x23, 0x27, 0x07, 0x0F, 0x08};
  for (std::size_t k = 0; k < bits.size(); ++k) EXPECT_EQ(power_status(kStates[k]) & 0x6F, bits[k]);
}

/// Controlwords one after the other, and the state each leads to, as the statusword tells.
struct Step
{
  int word, state;
};

void walk(DriveBench& bench, std::initializer_list<Step> steps)
{
  for (const Step& step : steps)
  {
    ASSERT_EQ(bench.control(step.word), 0u);
    ASSERT_EQ(bench.state(), step.state) << "after " << std::hex << step.word;
  }
}

TEST(PowerState, WalksThroughTheStatesOverSdo)
{
  DriveBench bench;
  bench.boot();
  walk(bench, {{0x0F, 0x40},
               {0x07, 0x40},
               {0x06, 0x21},
               {0x07, 0x23},
               {0x0F, 0x27},
               {0x07, 0x23},
               {0x06, 0x21},
               {0x0F, 0x27},
               {0x06, 0x21},
               {0x02, 0x40},
               {0x06, 0x21},
               {0x07, 0x23},
               {0x00, 0x40}});
}

TEST(PowerState, ResetsAFaultOnTheRisingEdgeOnly)
{
  DriveBench bench;
  bench.boot();
  bench.control(0x80);
  bench.drive.fail(0x2310);
  walk(bench, {{0x80, 0x08}, {0x8F, 0x08}, {0x00, 0x08}, {0x06, 0x08}, {0x80, 0x40}, {0x80, 0x40}, {0x06, 0x21}});
}

TEST(PowerState, IsNotReadyRightAfterTheBootUp)
{
  DriveBench bench;
  bench.pass(0.105);
  EXPECT_EQ(bench.read(0x6041) & 0x6F, 0x00u);
  bench.control(0x06);
  EXPECT_EQ(bench.state(), 0x00);
  bench.pass(0.05);
  EXPECT_EQ(bench.state(), 0x40);
}

}  // namespace
}  // namespace fourwis::drives
