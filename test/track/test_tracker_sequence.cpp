// Alignment, switches, corrections, and one trajectory after another.

#include <gtest/gtest.h>

#include <set>

#include "track_fixture.h"

namespace fourwis
{
namespace
{

Trajectory sideways(const Robot& robot, const Pose& from = {})
{
  return trajectory_of(robot, from, {{Mode::lateral, 0.1, 1.0}});
}

double greatest_speed(const WheelCommand& command)
{
  double greatest = 0.0;
  for (const double speed : command.motion.speed) greatest = std::max(greatest, std::abs(speed));
  return greatest;
}

TEST(TrackerSequence, TurnsWheelsAtRestAndDrivesOnceTheyAreAligned)
{
  Rig rig;
  ASSERT_EQ(rig.tracker.accept(trajectory_of(rig.robot, {}, {{Mode::ackermann, 0.0, 1.0}, {Mode::lateral, 0.0, 1.0}})),
            "");
  bool drove_lateral = false;
  while (!is_resting(rig.step().state) || rig.output.state == TrackState::idle)
  {
    const WheelState& wheels = rig.base.wheels();
    if (greatest_speed(rig.output.command) == 0.0) continue;
    const bool lateral = rig.output.command.mode == Mode::lateral;
    drove_lateral |= lateral;
    EXPECT_NEAR(std::abs(std::sin(wheels.motion.angle[0])), lateral ? 1.0 : 0.0, 0.05);
  }
  EXPECT_EQ(rig.output.state, TrackState::arrived) << rig.message;
  EXPECT_TRUE(drove_lateral);
}

/// What the base says of commands before this alignment does not count.
TEST(TrackerSequence, AlignedCountsOnlyForACommandOfThisAlignment)
{
  const std::vector<std::function<void(TrackInput&)>> lies = {
    [](TrackInput& input) { input.wheels.mode = Mode::ackermann; },
    [](TrackInput& input) { input.wheels.sequence = 0; },      // from before
    [](TrackInput& input) { input.wheels.sequence += 1000; },  // of another controller
    [](TrackInput& input) { input.wheels.sequence = 0xfffffff0u; },
    [](TrackInput& input) { input.wheels.aligned = false; },
  };
  for (std::size_t i = 0; i < lies.size(); ++i)
  {
    SCOPED_TRACE(i);
    Rig rig;
    for (int k = 0; k < 10; ++k) rig.step();
    ASSERT_EQ(rig.tracker.accept(sideways(rig.robot)), "");
    rig.tamper = [&](TrackInput& input)
    {
      input.wheels.aligned = true;
      lies[i](input);
    };
    for (int k = 0; k < 100; ++k)
    {
      EXPECT_EQ(rig.step().state, TrackState::aligning);
      EXPECT_EQ(greatest_speed(rig.output.command), 0.0);
    }
    rig.tamper = {};
    EXPECT_TRUE(rig.step_until(TrackState::arrived));
  }
}

/// The rig's clock, `seconds` later.
std::function<void(TrackInput&)> later(double seconds)
{
  return [seconds](TrackInput& input)
  {
    for (double* time : {&input.now, &input.pose_stamp, &input.wheels.stamp}) *time += seconds;
  };
}

TEST(TrackerSequence, CommandsAreNumberedLikeTheControlSteps)
{
  Rig rig;
  rig.tamper = later(1000.0);
  EXPECT_EQ(rig.step().command.sequence, 50000u);
  EXPECT_EQ(rig.step().command.sequence, 50001u);
  rig.tamper = later(1010.0);
  EXPECT_EQ(rig.step().command.sequence, 50502u);
  rig.tamper = later(500.0);
  EXPECT_EQ(rig.step().command.sequence, 50503u) << "a clock that runs back";
}

TEST(TrackerSequence, TheSequenceMayWrapAround)
{
  Rig rig;
  rig.tamper = later(0x1p32 / 50.0 - 0.1);
  EXPECT_GT(rig.step().command.sequence, 0xfffffff0u);
  ASSERT_EQ(rig.tracker.accept(sideways(rig.robot)), "");
  EXPECT_TRUE(rig.step_until(TrackState::arrived));
  EXPECT_LT(rig.output.command.sequence, 1000u);
}

TEST(TrackerSequence, ANewTrajectoryWhileDrivingStopsFirst)
{
  Rig rig;
  ASSERT_EQ(rig.tracker.accept(trajectory_of(rig.robot, {}, {{Mode::ackermann, 0.1, 5.0}})), "");
  ASSERT_TRUE(rig.step_until_fast(0.9));
  // It begins where the robot will come to rest: 0.1 m farther on.
  const Pose rest = advance(rig.robot, rig.base.pose(), Mode::ackermann, 0.1, 0.1);
  const Trajectory next = sideways(rig.robot, rest);
  ASSERT_EQ(rig.tracker.accept(next), "");
  std::set<TrackState> seen;
  rig.step_until(
    [&]
    {
      seen.insert(rig.output.state);
      return is_resting(rig.output.state) && rig.output.state != TrackState::idle;
    });
  EXPECT_EQ(rig.output.state, TrackState::arrived) << rig.message;
  EXPECT_TRUE(seen.count(TrackState::stopping));
  EXPECT_LT(distance(rig.base.pose(), next.back().pose()), 0.01);
}

TEST(TrackerSequence, ATrajectoryThatBeginsElsewhereIsRefused)
{
  Rig rig;
  rig.step();
  const std::string refusal = rig.tracker.accept(sideways(rig.robot, {1.0, 0.0, 0.0}));
  EXPECT_EQ(refusal, "the trajectory begins 1.000 m and 0.000 rad from where the robot is");
  // While it drives nobody knows yet where it will come to rest.
  ASSERT_EQ(rig.tracker.accept(sideways(rig.robot)), "");
  ASSERT_TRUE(rig.step_until_fast());
  EXPECT_EQ(rig.tracker.accept(sideways(rig.robot, {5.0, 0.0, 0.0})), "");
  ASSERT_TRUE(rig.step_until(TrackState::failed));
  EXPECT_NE(rig.message.find("the trajectory begins "), std::string::npos) << rig.message;
}

TEST(TrackerSequence, ARefusedTrajectoryLeavesTheOneBeforeAlone)
{
  Rig rig;
  ASSERT_EQ(rig.tracker.accept(sideways(rig.robot)), "");
  ASSERT_TRUE(rig.step_until_fast());
  Trajectory broken = sideways(rig.robot);
  broken[1].x = NAN;
  EXPECT_NE(rig.tracker.accept(broken), "");
  EXPECT_TRUE(rig.step_until(TrackState::arrived));
}

TEST(TrackerSequence, WhatIsLeftOverAtTheGoalIsCorrected)
{
  for (const Pose& push : {Pose{0.0, 0.06, 0.0}, Pose{-0.05, -0.05, 0.0}, Pose{0.0, 0.0, 0.1}, Pose{0.03, 0.05, -0.1}})
  {
    Rig rig;
    const Trajectory trajectory = trajectory_of(rig.robot, {}, {{Mode::ackermann, 0.0, 2.0}});
    ASSERT_EQ(rig.tracker.accept(trajectory), "");
    ASSERT_TRUE(rig.step_until([&] { return rig.output.t > trajectory.back().t - 0.05; }));
    rig.base.push(compose(rig.base.pose(), push));
    EXPECT_TRUE(rig.step_until(TrackState::arrived, 30.0)) << rig.message;
    EXPECT_LE(distance(rig.base.pose(), trajectory.back().pose()), 0.01);
    EXPECT_LE(std::abs(rig.base.pose().theta), 0.5 * M_PI / 180);
  }
}

TEST(TrackerSequence, AGoalThatCannotBeReachedIsGivenUpInBoundedTime)
{
  Rig rig;
  const Trajectory trajectory = trajectory_of(rig.robot, {}, {{Mode::ackermann, 0.0, 2.0}});
  ASSERT_EQ(rig.tracker.accept(trajectory), "");
  ASSERT_TRUE(rig.step_until([&] { return rig.output.t > trajectory.back().t - 0.05; }));
  rig.tamper = [](TrackInput& input) { input.pose = {2.0, 0.05, 0.0}; };  // wherever it goes, it does not get nearer
  EXPECT_TRUE(rig.step_until([&] { return is_resting(rig.output.state); }, 15.0));
  EXPECT_EQ(rig.output.state, TrackState::failed);
  EXPECT_NE(rig.message.find("from the goal and could not get nearer"), std::string::npos) << rig.message;
}

TEST(TrackerSequence, AfterAnArrivalTheNextTrajectoryIsDriven)
{
  Rig rig;
  Pose at = {};
  for (const Mode mode : {Mode::ackermann, Mode::lateral, Mode::parallel, Mode::ackermann})
  {
    const Trajectory trajectory = trajectory_of(rig.robot, at, {{mode, 0.2, 0.7}});
    ASSERT_EQ(rig.tracker.accept(trajectory), "");
    EXPECT_TRUE(rig.step_until([&] { return rig.output.state == TrackState::driving; }));
    EXPECT_TRUE(rig.step_until(TrackState::arrived));
    at = trajectory.back().pose();
  }
}

}  // namespace
}  // namespace fourwis
