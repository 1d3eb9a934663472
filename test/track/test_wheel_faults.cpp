// Wheels that break while the simulated base drives. The robot stops near its path with a message, or reaches the goal.

#include <gtest/gtest.h>

#include "simulator_rig.h"
#include "track_fixture.h"

namespace fourwis
{
namespace
{

const std::vector<Piece> kSlalom = {
    {Mode::ackermann, 0.4, 1.0}, {Mode::ackermann, -0.4, 1.0}, {Mode::ackermann, 0.0, 3.0}};

/// Breaks a wheel during the drive. Returns the result and how far the robot got from its path.
struct Outcome
{
  TrackState state;
  std::string message;
  double worst_lateral;
  bool rests;
};

Outcome outcome_of(WheelFault::Kind kind, int wheel, double moment)
{
  SimulatorRig rig({});
  EXPECT_EQ(rig.tracker.accept(trajectory_of(rig.robot, {}, kSlalom)), "");
  Outcome outcome = {};
  bool broken = false;
  rig.run(60.0, [&] {
    if (rig.output.state == TrackState::driving)
      outcome.worst_lateral = std::max(outcome.worst_lateral, std::abs(rig.output.lateral_error));
    if (broken || rig.output.t < moment) return;
    rig.base.inject({kind, wheel});
    broken = true;
  });
  outcome.state = rig.output.state;
  outcome.message = rig.message;
  rig.base.step(1.0);
  outcome.rests = std::hypot(rig.base.twist().vx, rig.base.twist().vy) < 0.01;
  return outcome;
}

TEST(WheelFaults, StuckSteeringStopsTheRobot)
{
  for (int wheel = 0; wheel < kWheels; ++wheel)
  {
    const Outcome outcome = outcome_of(WheelFault::Kind::stuck_steering, wheel, 0.5);
    EXPECT_EQ(outcome.state, TrackState::failed) << wheel;
    EXPECT_NE(outcome.message.find("wheel"), std::string::npos) << wheel << " " << outcome.message;
    EXPECT_LT(outcome.worst_lateral, 0.2) << wheel;
    EXPECT_TRUE(outcome.rests);
  }
}

TEST(WheelFaults, ADeadDriveIsMadeUpForByTheOthers)
{
  for (int wheel = 0; wheel < kWheels; ++wheel)
  {
    const Outcome outcome = outcome_of(WheelFault::Kind::dead_drive, wheel, 0.5);
    EXPECT_EQ(outcome.state, TrackState::arrived) << wheel << " " << outcome.message;
    EXPECT_LT(outcome.worst_lateral, 0.02) << wheel;
  }
}

TEST(WheelFaults, FrozenEncodersStopTheRobot)
{
  for (int wheel = 0; wheel < kWheels; ++wheel)
  {
    const Outcome outcome = outcome_of(WheelFault::Kind::frozen_encoders, wheel, 0.5);
    EXPECT_EQ(outcome.state, TrackState::failed) << wheel;
    EXPECT_LT(outcome.worst_lateral, 0.2) << wheel;
    EXPECT_TRUE(outcome.rests);
  }
}

}  // namespace
}  // namespace fourwis
