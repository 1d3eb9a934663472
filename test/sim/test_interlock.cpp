#include "fourwis_navigation/sim/interlock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "fourwis_navigation/can/bridge/bridge_options.h"

namespace fourwis
{
namespace
{

constexpr double kStep = 0.001;
constexpr double kDegree = M_PI / 180.0;
using Stage = Interlock::Stage;

PerWheel all(double value)
{
  return {value, value, value, value};
}

struct InterlockOfWheels : testing::Test
{
  /// Advances the time by `duration` with these wheels.
  void pass(double duration, double angle, double speed)
  {
    const auto steps = std::lround(duration / kStep);
    for (long k = 0; k < steps; ++k) interlock.step(kStep, {all(angle), all(speed)});
  }

  Interlock interlock{{}};
};

TEST_F(InterlockOfWheels, LocksUntilAModeIsWanted)
{
  pass(1.0, 0.0, 0.0);
  EXPECT_EQ(interlock.stage(), Stage::locked);
  EXPECT_FALSE(interlock.may_turn());
  EXPECT_FALSE(interlock.may_drive());
  EXPECT_FALSE(interlock.aligned());
}

TEST_F(InterlockOfWheels, WaitsForATenthOfASecondOfStandstill)
{
  pass(1.0, 0.0, 0.3);
  interlock.command(Mode::lateral, all(1.5));
  pass(1.0, 0.0, 0.3);
  EXPECT_EQ(interlock.stage(), Stage::coming_to_rest);
  pass(0.09, 0.0, 0.004);
  pass(0.001, 0.0, 0.006);
  pass(0.099, 0.0, -0.004);
  EXPECT_EQ(interlock.stage(), Stage::coming_to_rest) << "99 ms since it was too fast";
  EXPECT_FALSE(interlock.may_turn());
  pass(0.001, 0.0, 0.004);
  EXPECT_EQ(interlock.stage(), Stage::aligning);
  EXPECT_TRUE(interlock.may_turn());
  EXPECT_FALSE(interlock.may_drive());
}

TEST_F(InterlockOfWheels, WaitsUntilTheyHaveBeenNearTheirAnglesFor50Milliseconds)
{
  pass(0.2, 0.0, 0.0);
  interlock.command(Mode::lateral, all(90.0 * kDegree));
  pass(0.3, 45.0 * kDegree, 0.0);
  pass(0.049, 88.1 * kDegree, 0.0);
  EXPECT_FALSE(interlock.aligned());
  pass(0.001, 87.9 * kDegree, 0.0);
  pass(0.049, 91.9 * kDegree, 0.0);
  EXPECT_FALSE(interlock.may_drive());
  pass(0.001, 91.9 * kDegree, 0.0);
  EXPECT_TRUE(interlock.aligned());
  EXPECT_TRUE(interlock.may_drive());
}

TEST_F(InterlockOfWheels, NeedsEveryWheel)
{
  pass(0.2, 0.0, 0.0);
  interlock.command(Mode::ackermann, all(0.0));
  for (int k = 0; k < 500; ++k) interlock.step(kStep, {{0.0, 0.0, 3.0 * kDegree, 0.0}, {}});
  EXPECT_FALSE(interlock.aligned());
  Interlock moving{{}};
  moving.command(Mode::ackermann, all(0.0));
  for (int k = 0; k < 500; ++k) moving.step(kStep, {{}, {0.0, 0.0, 0.0, -0.01}});
  EXPECT_EQ(moving.stage(), Stage::coming_to_rest);
}

TEST_F(InterlockOfWheels, StaysReleasedWithinAMode)
{
  pass(0.2, 0.0, 0.0);
  interlock.command(Mode::parallel, all(0.0));
  pass(0.1, 0.0, 0.0);
  ASSERT_TRUE(interlock.may_drive());
  interlock.command(Mode::parallel, all(0.3));
  EXPECT_TRUE(interlock.may_drive());
  EXPECT_FALSE(interlock.aligned()) << "with an angle far from the wheels no wheel is near it any more";
  pass(0.1, 0.3, 1.0);
  EXPECT_TRUE(interlock.aligned());
}

TEST_F(InterlockOfWheels, TreatsAJumpOfAnAngleAsAnotherMode)
{
  pass(0.2, 0.0, 0.0);
  interlock.command(Mode::parallel, all(0.0));
  pass(0.1, 0.0, 0.0);
  pass(0.1, 0.0, 1.0);
  interlock.command(Mode::parallel, all(19.0 * kDegree));
  EXPECT_TRUE(interlock.may_drive());
  interlock.command(Mode::parallel, {19.0 * kDegree, 19.0 * kDegree, 40.0 * kDegree, 19.0 * kDegree});
  EXPECT_EQ(interlock.stage(), Stage::coming_to_rest);
}

TEST_F(InterlockOfWheels, LocksWithTheNextModeAndWithNone)
{
  for (Mode next : {Mode::lateral, Mode::none})
  {
    interlock.reset();
    pass(0.2, 0.0, 0.0);
    interlock.command(Mode::ackermann, all(0.0));
    pass(0.1, 0.0, 0.0);
    ASSERT_TRUE(interlock.may_drive());
    pass(0.1, 0.0, 1.0);
    interlock.command(next, all(0.0));
    EXPECT_FALSE(interlock.may_turn());
    EXPECT_FALSE(interlock.may_drive());
    EXPECT_EQ(interlock.stage(), next == Mode::none ? Stage::locked : Stage::coming_to_rest);
  }
  interlock.command(Mode::ackermann, all(0.0));
  EXPECT_EQ(interlock.stage(), Stage::coming_to_rest) << "after none the mode before is a new one";
}

TEST_F(InterlockOfWheels, FailsWhenTheyDoNotAlignAndSaysSoUntilReset)
{
  pass(0.2, 0.0, 0.0);
  interlock.command(Mode::lateral, all(1.5));
  pass(2.99, 0.0, 0.0);
  EXPECT_EQ(interlock.stage(), Stage::aligning);
  pass(0.02, 0.0, 0.0);
  EXPECT_EQ(interlock.stage(), Stage::failed);
  interlock.command(Mode::ackermann, all(0.0));
  pass(1.0, 0.0, 0.0);
  EXPECT_EQ(interlock.stage(), Stage::failed);
  EXPECT_FALSE(interlock.may_turn());
  interlock.reset();
  interlock.command(Mode::ackermann, all(0.0));
  pass(0.2, 0.0, 0.0);
  EXPECT_TRUE(interlock.may_drive());
}

TEST_F(InterlockOfWheels, FailsWhenTheyDoNotComeToRest)
{
  interlock.command(Mode::lateral, all(0.0));
  pass(3.1, 0.0, 0.3);
  EXPECT_EQ(interlock.stage(), Stage::failed);
}

TEST_F(InterlockOfWheels, GivesThemTheTimeToAlignAfterThatToComeToRest)
{
  interlock.command(Mode::lateral, all(1.5));
  pass(2.8, 0.0, 0.3);
  pass(2.8, 0.0, 0.0);
  EXPECT_EQ(interlock.stage(), Stage::aligning);
  pass(0.4, 0.0, 0.0);
  EXPECT_EQ(interlock.stage(), Stage::failed);
}

TEST(InterlockOptions, AreThoseOfTheBridge)
{
  const InterlockOptions options;
  const can::BridgeOptions bridge;
  EXPECT_EQ(options.standstill_speed, bridge.standstill_speed);
  EXPECT_EQ(options.standstill_time, bridge.standstill_time);
  EXPECT_EQ(options.aligned_angle, bridge.aligned_tolerance);
  EXPECT_EQ(options.aligned_time, bridge.aligned_time);
  EXPECT_EQ(options.alignment_timeout, bridge.stop_timeout);
  EXPECT_EQ(options.alignment_timeout, bridge.alignment_timeout);
}

TEST_F(InterlockOfWheels, RejectsInvalidOptions)
{
  InterlockOptions options;
  options.aligned_angle = 0.0;
  EXPECT_THROW(Interlock{options}, std::invalid_argument);
  options = {};
  // As the bridge's: the simulator once took a hundredth of it.
  options.standstill_speed = 1e-4;
  EXPECT_NO_THROW(Interlock{options});
  options.standstill_speed = std::nextafter(1e-4, 0.0);
  EXPECT_THROW(Interlock{options}, std::invalid_argument);
  options = {};
  options.standstill_time = NAN;
  EXPECT_THROW(Interlock{options}, std::invalid_argument);
}

}  // namespace
}  // namespace fourwis
