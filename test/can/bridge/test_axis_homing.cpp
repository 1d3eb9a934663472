#include "can/bridge/axis_homing.h"

#include <gtest/gtest.h>

namespace fourwis::can
{
namespace
{

constexpr double kTimeout = 20.0;
const std::int8_t kMode = static_cast<std::int8_t>(OperationMode::homing);
const DriveStatus kSearching{0x0227, kMode}, kAttained{0x1627, kMode}, kFailed{0x2227, kMode};

class Homing : public testing::Test
{
protected:
  Homing() { homing_.begin(); }

  /// The drive is in homing mode and is told to begin.
  void start(double now)
  {
    EXPECT_EQ(homing_.bits(kSearching, now), control::homing_start);
    EXPECT_TRUE(homing_.running());
  }

  Fault fault() const { return log_.cause().fault; }

  FaultLog log_;
  AxisHoming homing_{true, kTimeout, {log_, 0}};
};

TEST_F(Homing, IsDoneWhenTheDriveSaysSoOfThisTime)
{
  EXPECT_EQ(homing_.bits({0x0227, 8}, 1.0), 0) << "the drive is in another mode";
  EXPECT_FALSE(homing_.running());
  start(1.0);
  homing_.supervise(kAttained, 1.01);
  EXPECT_FALSE(homing_.done()) << "of an earlier one";
  homing_.supervise({kAttained.statusword, 8}, 1.1);
  EXPECT_FALSE(homing_.done()) << "these bits mean something else in another mode";
  homing_.supervise(kAttained, 1.1);
  EXPECT_TRUE(homing_.done());
  EXPECT_FALSE(homing_.running());
  EXPECT_EQ(fault(), Fault::count);
}

TEST_F(Homing, ThatFailsOrDoesNotEndIsAFault)
{
  start(1.0);
  homing_.supervise(kFailed, 1.1);
  EXPECT_EQ(fault(), Fault::homing_failed);
  log_.clear();
  homing_.supervise(kSearching, 1.0 + 0.99 * kTimeout);
  EXPECT_EQ(fault(), Fault::count);
  // The mode that the drive reports does not matter.
  homing_.supervise({0x0250, 0}, 1.0 + 1.01 * kTimeout);
  EXPECT_EQ(fault(), Fault::homing_failed);
}

TEST_F(Homing, BeginsAnewAfterItWasInterrupted)
{
  start(1.0);
  homing_.interrupt();
  homing_.supervise(kSearching, 2.0 * kTimeout);
  start(3.0 * kTimeout);
  homing_.supervise(kAttained, 3.0 * kTimeout + 0.1);
  EXPECT_TRUE(homing_.done());
  EXPECT_EQ(fault(), Fault::count);
}

}  // namespace
}  // namespace fourwis::can
