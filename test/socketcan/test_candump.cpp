#include <array>

#include "../can/bus/bus_laws.h"
#include "candump.h"
#include "vcan_rig.h"

namespace fourwis::can
{
namespace
{

struct Sample
{
  Frame frame;
  const char* text;  ///< as candump and cansend write it
};

const std::array<Sample, 7> kSamples{{
    {{0x000, false, false, false, 2, {0x01, 0x00}}, "000#0100"},
    {{0x080, false, false, false, 0, {}}, "080#"},
    {{0x201, false, false, false, 7, {0x0f, 0, 8, 0x12, 0x34, 0x56, 0x78}}, "201#0F000812345678"},
    {{0x7ff, false, false, false, 8, {1, 2, 3, 4, 5, 6, 7, 255}}, "7FF#01020304050607FF"},
    {{0x123, true, false, false, 1, {0xab}}, "00000123#AB"},
    {{0x1fffffff, true, false, false, 1, {0xab}}, "1FFFFFFF#AB"},
    {{0x701, false, true, false, 0, {}}, "701#R"},
}};

TEST(Candump, ShowsWhatIsSent)
{
  VcanRig rig;
  const auto bus = rig.open();
  Candump candump;
  std::vector<std::string> expected;
  for (const Sample& sample : kSamples)
  {
    ASSERT_EQ(bus->send(sample.frame), BusStatus::ok) << bus->last_error();
    expected.push_back(sample.text);
  }
  EXPECT_EQ(candump.frames(), expected);
}

TEST(Candump, ShowsAnInjectedBusOff)
{
  VcanRig rig;
  const auto bus = rig.open();
  Candump candump;
  ASSERT_EQ(bus->send({0x40, false, false, true, 8, {}}), BusStatus::ok) << bus->last_error();
  EXPECT_EQ(candump.frames(), std::vector<std::string>{"20000040#0000000000000000"});
}

TEST(Cansend, IsReceivedAsItWasSent)
{
  VcanRig rig;
  const auto bus = rig.open();
  for (const Sample& sample : kSamples)
  {
    run(std::string("cansend vcan0 ") + sample.text);
    EXPECT_EQ(next_frame(*bus), sample.frame) << sample.text;
  }
}

}  // namespace
}  // namespace fourwis::can
