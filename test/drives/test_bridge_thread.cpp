#include "fourwis_navigation/can/bridge/bridge_thread.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>
#include <unistd.h>

#include "../support/sentences.h"
#include "fourwis_navigation/can/bus/real_time.h"
#include "real_time_drives.h"

namespace fourwis
{
namespace
{

using can::BridgeStage;
using can::BridgeUpdate;

/// Longer than any step of these tests takes on the slowest machine [s].
constexpr double kPatience = 30.0;

/// These tests do not measure time, because a busy machine may be slow.
can::BridgeOptions patient()
{
  can::BridgeOptions options;
  options.command_timeout = options.drive_watchdog = options.heartbeat_timeout = options.feedback_timeout =
      options.following_time = 2.0;
  return options;
}

/// A bridge in its thread and drives in theirs, on a bus among processes.
class BridgeInItsThread : public testing::Test
{
protected:
  /// Waits for the updates of the bridge and gives a command in each cycle, until the condition holds.
  bool follow_until(const std::function<bool()>& condition)
  {
    const double end = can::monotonic_now() + kPatience;
    while (can::monotonic_now() < end)
    {
      if (!bridge_.wait(update_, kPatience)) return false;
      if (condition()) return true;
      ++wanted_.sequence;
      bridge_.command(wanted_);
    }
    return false;
  }

  bool follow_until(BridgeStage stage)
  {
    return follow_until([&] { return update_.report.stage == stage; });
  }

  bool enable()
  {
    return follow_until(BridgeStage::ready) && bridge_.enable().empty() && follow_until(BridgeStage::enabled);
  }

  const std::string name_ = "unix:bridge_thread_" + std::to_string(getpid());
  RealTimeDrives drives_{name_};
  can::BridgeThread bridge_{Robot(), patient(), can::open_bus(name_), 0};
  BridgeUpdate update_;
  WheelCommand wanted_;
};

TEST_F(BridgeInItsThread, DrivesAndStops)
{
  wanted_.mode = Mode::ackermann;
  wanted_.motion.speed.fill(0.5);
  ASSERT_TRUE(enable()) << text_of(update_.report.cause);
  ASSERT_TRUE(follow_until([&] { return drives_.forward_speed() > 0.45; })) << text_of(update_.report.cause);
  EXPECT_GT(update_.delays.count(), 0u);
  EXPECT_EQ(bridge_.disable(), "");
  EXPECT_TRUE(follow_until([&] { return update_.report.out_of_operation; })) << text_of(update_.report.cause);
  EXPECT_LT(std::abs(drives_.forward_speed()), 0.01);
}

TEST_F(BridgeInItsThread, SaysWhyItRefuses)
{
  bridge_.press_emergency_stop(true);
  ASSERT_TRUE(follow_until(BridgeStage::ready)) << text_of(update_.report.cause);
  EXPECT_EQ(bridge_.enable(), "the emergency stop is pressed");
  bridge_.press_emergency_stop(false);
  ASSERT_TRUE(follow_until([&] { return !update_.report.emergency_stop; }));
  EXPECT_EQ(bridge_.enable(), "");
}

TEST_F(BridgeInItsThread, StopsForAnEmergencyStopThatIsReleasedBeforeItCouldLook)
{
  wanted_.mode = Mode::ackermann;
  ASSERT_TRUE(enable()) << text_of(update_.report.cause);
  bridge_.press_emergency_stop(true);
  bridge_.press_emergency_stop(false);
  ASSERT_TRUE(follow_until(BridgeStage::ready));
  EXPECT_EQ(update_.report.cause.fault, can::Fault::emergency_stop) << text_of(update_.report.cause);
  EXPECT_FALSE(update_.report.emergency_stop);
}

TEST(BridgeThread, RejectsOptionsThatContradictEachOtherWhereItIsMade)
{
  can::BridgeOptions options;
  options.driving[0].node = 1;
  EXPECT_THROW(can::BridgeThread(Robot(), options, can::open_bus("unix:nothing"), 0), std::invalid_argument);
}

// The constructor returns while the thread has only begun.
TEST(BridgeThread, StartsAndEndsManyTimes)
{
  const std::string name = "unix:bridge_starts_" + std::to_string(getpid());
  for (int k = 0; k < 200; ++k)
    EXPECT_EQ(can::BridgeThread(Robot(), can::BridgeOptions(), can::open_bus(name), 0).complaint(), "");
}

TEST(BridgeThread, RejectsAPriorityThatDoesNotExist)
{
  for (const int bad : {-1, 100})
    EXPECT_EQ(
        error_of<std::invalid_argument>([&] { can::BridgeThread(Robot(), {}, can::open_bus("unix:nothing"), bad); }),
        "parameter 'priority' is " + std::to_string(bad) + ", expected a whole number from 0 to 99");
}

}  // namespace
}  // namespace fourwis
