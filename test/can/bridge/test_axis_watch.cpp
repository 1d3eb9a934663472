#include "can/bridge/axis_watch.h"

#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace fourwis::can
{
namespace
{

constexpr double kCycle = 0.01;
/// Of the axis [counts/s].
constexpr double kMaxSpeed = 1e6;

/// A drive that has been started, and its SYNCs.
class WatchedAxis : public testing::Test
{
protected:
  WatchedAxis() { watch_.begin(now_); }

  void sync()
  {
    now_ += kCycle;
    watch_.receive_heartbeat(NmtState::operational, now_);
    watch_.supervise(now_);
    watch_.sync_sent();
  }

  void answer(std::int32_t position = 0)
  {
    watch_.receive_status(now_);
    watch_.receive_motion(position, now_);
  }

  Fault fault() const { return log_.cause().fault; }

  const BridgeOptions options_;
  FaultLog log_;
  AxisWatch watch_{options_, kMaxSpeed, 1.0, Fault::speed_not_followed, {log_, 0}};
  double now_ = 0.0;
};

TEST_F(WatchedAxis, IsLostWhenItHasNotAnsweredForTheFeedbackTimeout)
{
  sync();
  const double asked = now_;
  while (fault() == Fault::count && now_ < 1.0) sync();
  EXPECT_EQ(fault(), Fault::feedback_lost);
  EXPECT_NEAR(now_ - asked, options_.feedback_timeout, 1e-9);
}

TEST_F(WatchedAxis, MayAnswerLateAndThenAllAtOnce)
{
  for (int round = 0; round < 10; ++round)
  {
    for (int i = 0; i < 5; ++i) sync();
    for (int i = 0; i < 5; ++i) answer();
  }
  EXPECT_EQ(fault(), Fault::count);
}

TEST_F(WatchedAxis, IsTwoIfItGoesOnAnsweringTwice)
{
  for (int i = 0; i < 10; ++i)
  {
    sync();
    answer();
    answer();
  }
  EXPECT_EQ(fault(), Fault::duplicate_node);
}

TEST_F(WatchedAxis, BeginsAgainAtTheOtherEndOfItsRangeWithoutAJump)
{
  const std::uint32_t step = static_cast<std::uint32_t>(kMaxSpeed * kCycle);
  std::uint32_t position = std::numeric_limits<std::int32_t>::max() - 2 * step;
  for (int i = 0; i < 5; ++i)
  {
    sync();
    answer(static_cast<std::int32_t>(position));
    position += step;
  }
  EXPECT_EQ(fault(), Fault::count);
  sync();
  answer(static_cast<std::int32_t>(position + 10 * step));
  EXPECT_EQ(fault(), Fault::encoder_jump);
}

}  // namespace
}  // namespace fourwis::can
