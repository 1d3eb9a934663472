#include "can/bridge/sdo_script.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace fourwis::can
{
namespace
{

const Robot kRobot;

std::uint32_t value_of(const SdoScript& script, std::uint16_t index)
{
  const auto step =
      std::find_if(script.begin(), script.end(), [&](const SdoStep& s) { return s.object.index == index; });
  return step == script.end() ? 0 : step->value;
}

TEST(SdoScript, RampsHaveNoSignAndAllOfTheir32Bits)
{
  BridgeOptions options;
  for (const bool reversed : {false, true})
  {
    AxisOptions axis = options.driving[1];
    axis.counts_per_turn = 8388608.0;
    axis.gear_ratio = 20.0;
    axis.reversed = reversed;
    const double counts = axis.counts_per_turn * axis.gear_ratio / (2.0 * M_PI * options.wheel_radius);
    const SdoScript script = configuration_script(kRobot, options, axis, false);
    EXPECT_EQ(value_of(script, 0x6083), std::llround(options.max_acceleration * counts));
    EXPECT_EQ(value_of(script, 0x6084), std::llround(options.max_acceleration * counts));
    EXPECT_EQ(value_of(script, 0x6085), std::llround(options.stop_deceleration * counts));
  }
}

}  // namespace
}  // namespace fourwis::can
