#include "../can/protocol/frame_bytes.h"
#include "../support/fuzz_rounds.h"
#include "../support/random.h"
#include "bridge_fixture.h"

namespace fourwis
{
namespace
{

using can::BridgeStage;

/// Invalid and unexpected frames, at any time.
class BridgeAmongGarbage : public BridgeFixture
{
protected:
  /// Mostly with identifiers that the bridge uses.
  can::Frame garbage()
  {
    if (random_.chance(0.3)) return can::random_frame(random_);
    const std::uint32_t bases[] = {0x000, 0x080, 0x180, 0x200, 0x280, 0x580, 0x600, 0x700};
    return can::random_frame(random_, bases[random_.whole(0, 7)] + static_cast<std::uint32_t>(random_.whole(0, 9)));
  }

  Random random_{14};
};

TEST_F(BridgeAmongGarbage, NeverMovesAnythingThatWasNotEnabled)
{
  command(Mode::ackermann, 0.0, 0.5);
  for (int i = 0; i < fuzz_rounds(20000); ++i)
  {
    if (random_.chance(0.1)) end->inject(garbage());
    if (random_.chance(0.001)) bridge.clear_faults(now());
    tick();
    ASSERT_NE(stage(), BridgeStage::enabled);
  }
  EXPECT_LT(last_motion(), 0.0);
  EXPECT_EQ(fastest_wheel(), 0.0);
}

TEST_F(BridgeAmongGarbage, StopsForGoodOrGoesOnButWorksAgainWhenItIsOver)
{
  for (int round = 0; round < fuzz_rounds(50); ++round)
  {
    drive();
    double stopped = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 30; ++i)
    {
      end->inject(garbage());
      tick();
      if (stage() != BridgeStage::enabled) stopped = std::min(stopped, now());
    }
    pass(0.5);
    EXPECT_LE(last_motion(), stopped) << cause();
    ASSERT_LT(wait_for([&] { return bridge.clear_faults(now()) == nullptr; }), 6.0) << cause();
  }
}

}  // namespace
}  // namespace fourwis
