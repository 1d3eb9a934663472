#include <gtest/gtest.h>

#include "../support/fuzz_rounds.h"
#include "../support/random.h"
#include "drive_bench.h"

namespace fourwis::drives
{
namespace
{

constexpr unsigned kSeed = 402;

can::Frame random_frame(Random& random)
{
  static const std::uint32_t ids[] = {0x000, 0x080, 0x085, 0x185, 0x205, 0x305,
                                      0x405, 0x505, 0x585, 0x605, 0x705, 0x77F};
  can::Frame frame;
  frame.id = random.chance(0.8) ? ids[random.whole(0, 11)] : static_cast<std::uint32_t>(random.whole(0, 0x7FF));
  frame.size = static_cast<std::uint8_t>(random.whole(0, 8));
  for (std::uint8_t& byte : frame.data) byte = static_cast<std::uint8_t>(random.whole(0, 255));
  frame.extended = random.chance(0.05);
  frame.remote = random.chance(0.05);
  frame.error = random.chance(0.05);
  return frame;
}

/// Whether the controlword that enables is anywhere in the frame.
bool could_enable(const can::Frame& frame)
{
  for (std::size_t k = 0; k < frame.size; ++k)
    if ((frame.data[k] & 0x8F) == 0x0F) return true;
  return false;
}

/// Two hundred thousand frames, none of which says `enable operation`.
TEST(DriveFuzz, RandomFramesDoNotEnableADrive)
{
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed);
  DriveBench bench;
  bench.boot();
  for (int k = 0; k < fuzz_rounds(200000); ++k)
  {
    const can::Frame frame = random_frame(random);
    if (!could_enable(frame)) bench.drive.receive(bench.time(), frame);
    if (k % 20 == 0) bench.step();
    ASSERT_NE(bench.drive.power_state(), PowerState::operation_enabled) << can::text(frame);
    ASSERT_EQ(bench.motor.velocity, 0.0);
  }
}

/// Any frames, with faults in between: the drive sends valid frames, and its demands are finite numbers.
TEST(DriveFuzz, NothingBreaksIt)
{
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  Random random(kSeed + 1);
  DriveBench bench;
  bench.boot();
  int enabled = 0;
  for (int k = 0; k < fuzz_rounds(200000); ++k)
  {
    bench.drive.receive(bench.time(), random_frame(random));
    if (random.chance(0.02)) bench.enable_if_possible();
    if (random.chance(0.001)) bench.drive.fail(static_cast<std::uint16_t>(random.whole(0x1000, 0xFFFF)));
    if (random.chance(0.0005)) bench.drive.reboot(bench.time());
    if (random.chance(0.001)) bench.drive.shift_encoder(random.between(-1e6, 1e6));
    if (k % 5 == 0) bench.step();
    enabled += bench.drive.power_state() == PowerState::operation_enabled;
    ASSERT_TRUE(std::isfinite(bench.drive.demand().value));
    for (const can::Frame& frame : bench.sent) ASSERT_TRUE(can::is_valid(frame));
    bench.sent.clear();
  }
  EXPECT_GT(enabled, 1000) << "else this says little";
}

}  // namespace
}  // namespace fourwis::drives
