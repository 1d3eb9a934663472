#include "fourwis_navigation/drives/bus_base.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "../can/bus/temporary_directory.h"
#include "raw_master.h"

namespace fourwis::drives
{
namespace
{

/// The base at a bus of processes, and a master at another end of it.
class BusBaseTest : public ::testing::Test
{
protected:
  BusBaseTest()
  {
    setenv("XDG_RUNTIME_DIR", directory_.path().c_str(), 1);
    base.emplace("unix:drives", Robot(), can::BridgeOptions(), SimulatorOptions());
    end = can::open_bus("unix:drives");
    base->advance(0.0);
  }

  void pass(double seconds)
  {
    const auto steps = std::lround(seconds * 1e3);
    for (long k = 0; k < steps; ++k)
    {
      now += 0.001;
      base->advance(now);
      for (can::Frame frame; end->receive(frame) == can::BusStatus::ok;) heard.push_back(frame);
    }
  }

  can::TemporaryDirectory directory_;
  std::optional<BusBase> base;
  std::unique_ptr<can::Bus> end;
  double now = 0.0;
  Frames heard;
};

TEST_F(BusBaseTest, IsThereForOtherProcesses)
{
  pass(0.15);
  for (std::uint32_t node = 1; node <= 8; ++node) EXPECT_TRUE(contains(heard, raw(0x700 + node, {0x00})));
  end->send(raw(0x603, {0x40, 0x18, 0x10, 4, 0, 0, 0, 0}));
  pass(0.002);
  EXPECT_TRUE(contains(heard, raw(0x583, {0x43, 0x18, 0x10, 4, 3, 0, 0, 0})));
}

TEST_F(BusBaseTest, LivesAsLongAsItsClock)
{
  pass(0.123);
  EXPECT_NEAR(base->drives().time(), 0.123, 1.1e-3);
}

TEST_F(BusBaseTest, LeavesOutWhatItHasMissed)
{
  pass(0.1);
  now += 10.0;
  pass(0.1);
  EXPECT_NEAR(base->drives().time(), 0.2 + BusBase::kMostCaughtUp, 2.1e-3);
  base->advance(now - 5.0);
  EXPECT_NEAR(base->drives().time(), 0.2 + BusBase::kMostCaughtUp, 2.1e-3) << "a clock that goes back";
}

TEST_F(BusBaseTest, FindsItsBusAgain)
{
  pass(0.15);
  std::filesystem::remove_all(std::filesystem::path(directory_.path()) / "fourwis_can");
  pass(0.05);
  end = can::open_bus("unix:drives");
  heard.clear();
  pass(0.05);
  end->send(raw(0x603, {0x40, 0x18, 0x10, 4, 0, 0, 0, 0}));
  pass(0.05);
  EXPECT_TRUE(contains(heard, raw(0x583, {0x43, 0x18, 0x10, 4, 3, 0, 0, 0})));
}

TEST(BusBase, RefusesANameThatIsNone)
{
  EXPECT_THROW(BusBase("unix:", Robot(), can::BridgeOptions(), SimulatorOptions()), std::invalid_argument);
}

}  // namespace
}  // namespace fourwis::drives
