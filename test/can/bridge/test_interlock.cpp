#include "can/bridge/interlock.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "can/bridge/setpoint.h"

namespace fourwis::can
{
namespace
{

constexpr double kCycle = 0.01;
const BridgeOptions kOptions;

WheelCommand command(Mode mode, double angle, double speed)
{
  WheelCommand command;
  command.mode = mode;
  command.motion.angle.fill(angle);
  command.motion.speed.fill(speed);
  return command;
}

/// Wheels that follow their set-point at once.
class InterlockedWheels : public testing::Test
{
protected:
  InterlockedWheels() { interlock_.reset(now_); }

  void cycle(const WheelCommand& command)
  {
    now_ += kCycle;
    const WheelMotion target = interlock_.permit(command, wheels_, setpoint_.value(), now_);
    if (interlock_.holding())
      setpoint_.ramp_down(kCycle);
    else
      setpoint_.approach(target, kCycle);
    if (!stuck_) wheels_ = setpoint_.value();
    wheels_.speed[2] += creep_;
  }

  /// The time until the condition holds, at most a minute [s].
  double time_until(const WheelCommand& command, const std::function<bool()>& condition)
  {
    const double begin = now_;
    while (!condition() && now_ - begin < 60.0) cycle(command);
    return now_ - begin;
  }

  double speed() const { return greatest_magnitude(wheels_.speed); }

  Robot robot_;
  Interlock interlock_{kOptions};
  Setpoint setpoint_{robot_, kOptions};
  WheelMotion wheels_;
  bool stuck_ = false;
  double creep_ = 0.0;  ///< of one wheel, independent of its command [m/s]
  double now_ = 0.0;
};

TEST_F(InterlockedWheels, AtTheBeginningTheyTurnAtRestBeforeTheyDrive)
{
  const WheelCommand go = command(Mode::parallel, 1.0, 0.5);
  while (speed() == 0.0 && now_ < 5.0)
  {
    cycle(go);
    EXPECT_TRUE(speed() == 0.0 || std::abs(wheels_.angle[0] - 1.0) <= kOptions.aligned_tolerance);
  }
  EXPECT_TRUE(interlock_.aligned());
  EXPECT_EQ(interlock_.mode(), Mode::parallel);
  EXPECT_GE(now_, kOptions.standstill_time + 1.0 / robot_.wheel_max_rate);
}

TEST_F(InterlockedWheels, AnotherModeWaitsForStandstillAndAlignment)
{
  time_until(command(Mode::ackermann, 0.0, 0.5), [&] { return speed() >= 0.5; });
  const WheelCommand other = command(Mode::lateral, 1.5, 0.5);
  double stood = 0.0;
  while (wheels_.angle[0] < 0.01 && now_ < 5.0)
  {
    cycle(other);
    stood = speed() <= kOptions.standstill_speed ? stood + kCycle : 0.0;
    EXPECT_FALSE(interlock_.aligned());
    EXPECT_TRUE(wheels_.angle[0] == 0.0 || stood >= kOptions.standstill_time);
  }
  EXPECT_LT(time_until(other, [&] { return speed() > 0.0; }), 1.0);
  EXPECT_NEAR(wheels_.angle[0], 1.5, kOptions.aligned_tolerance);
}

TEST_F(InterlockedWheels, ABranchFlipWhileRollingIsAReorientation)
{
  time_until(command(Mode::ackermann, 0.1, 0.5), [&] { return speed() >= 0.5; });
  const WheelCommand flipped = command(Mode::ackermann, 0.1 - 2.0, -0.5);
  while (speed() > kOptions.standstill_speed && now_ < 5.0)
  {
    cycle(flipped);
    EXPECT_NEAR(wheels_.angle[0], 0.1, kOptions.aligned_tolerance);
  }
  EXPECT_LT(speed(), 0.01);
}

TEST_F(InterlockedWheels, SmoothSteeringAndACuspDoNotInterruptTheMotion)
{
  WheelCommand go = command(Mode::ackermann, 0.0, 1.0);
  time_until(go, [&] { return speed() >= 1.0; });
  for (int i = 0; i < 100; ++i)
  {
    go.motion.angle.fill(0.01 * i);
    go.motion.speed.fill(1.0 - 0.02 * i);
    cycle(go);
    EXPECT_FALSE(interlock_.holding());
    EXPECT_NEAR(wheels_.speed[0], go.motion.speed[0], 1e-9);
  }
}

TEST_F(InterlockedWheels, OnlyAJumpOf20DegreesInterruptsTheMotion)
{
  time_until(command(Mode::ackermann, 0.0, 0.5), [&] { return speed() >= 0.5; });
  constexpr double kDegree = M_PI / 180.0;
  for (int i = 0; i < 50; ++i)
  {
    cycle(command(Mode::ackermann, 19.0 * kDegree, 0.5));
    EXPECT_FALSE(interlock_.holding());
  }
  cycle(command(Mode::ackermann, (19.0 + 21.0) * kDegree, 0.5));
  EXPECT_TRUE(interlock_.holding());
}

TEST_F(InterlockedWheels, NoModeStopsByTheRampAndHoldsTheAngles)
{
  time_until(command(Mode::ackermann, 0.2, 1.0), [&] { return speed() >= 1.0; });
  const WheelCommand none = command(Mode::none, 0.0, 0.7);
  const double stop = time_until(none, [&] { return speed() == 0.0; });
  EXPECT_NEAR(stop, 1.0 / kOptions.stop_deceleration, 2.5 * kCycle);
  EXPECT_NEAR(wheels_.angle[0], 0.2, kOptions.aligned_tolerance);
}

TEST_F(InterlockedWheels, WheelsThatDoNotTurnAreOverdueAndNeverDriven)
{
  stuck_ = true;
  const double late = time_until(command(Mode::lateral, 1.5, 0.5), [&] { return interlock_.overdue(); });
  EXPECT_NEAR(late, kOptions.standstill_time + kOptions.alignment_timeout, 5 * kCycle);
  EXPECT_EQ(greatest_magnitude(setpoint_.value().speed), 0.0);
}

TEST_F(InterlockedWheels, ThatDoNotComeToRestAreOverdueAndNeverTurned)
{
  time_until(command(Mode::ackermann, 0.0, 0.5), [&] { return speed() >= 0.5; });
  creep_ = 1.2 * kOptions.standstill_speed;
  const double late = time_until(command(Mode::lateral, 1.5, 0.5), [&] { return interlock_.overdue(); });
  EXPECT_NEAR(late, kOptions.stop_timeout, 5 * kCycle);
  EXPECT_EQ(setpoint_.value().angle[0], 0.0);
  // A stop may take any time.
  time_until(command(Mode::none, 0.0, 0.0), [&] { return !interlock_.overdue(); });
  for (int i = 0; i < 1000; ++i) cycle(command(Mode::none, 0.0, 0.0));
  EXPECT_FALSE(interlock_.overdue());
}

/// Wheels that are blocked stand, but would roll as soon as they are free.
TEST_F(InterlockedWheels, AreNotTurnedAsLongAsTheyAreToldToRoll)
{
  const WheelCommand go = command(Mode::ackermann, 0.0, 0.5);
  time_until(go, [&] { return speed() >= 0.5; });
  stuck_ = true;
  wheels_.speed.fill(0.0);
  for (int i = 0; i < 50; ++i) cycle(go);
  double stood = 0.0;
  while (setpoint_.value().angle[0] == 0.0 && now_ < 5.0)
  {
    cycle(command(Mode::lateral, 1.5, 0.5));
    const bool stands = greatest_magnitude(setpoint_.value().speed) <= kOptions.standstill_speed;
    EXPECT_TRUE(setpoint_.value().angle[0] == 0.0 || stood >= kOptions.standstill_time - 2 * kCycle);
    stood = stands ? stood + kCycle : 0.0;
  }
  EXPECT_GT(stood, 0.0);
}

/// A base that steers by itself may have turned its wheels already.
TEST_F(InterlockedWheels, AreNotAlignedBeforeTheyHaveBeenToldTheirAngles)
{
  stuck_ = true;
  wheels_.angle.fill(1.5);
  while (!interlock_.aligned() && now_ < 5.0) cycle(command(Mode::lateral, 1.5, 0.5));
  EXPECT_NEAR(setpoint_.value().angle[0], 1.5, kOptions.aligned_tolerance);
}

}  // namespace
}  // namespace fourwis::can
