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

/// Reports of the base about commands before this alignment do not count.
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
    rig.tamper = [&](TrackInput& input) {
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

/// A report about any command since the beginning of this alignment counts.
TEST(TrackerSequence, AlignedCountsFromTheFirstCommandOfThisAlignmentOn)
{
  constexpr int kSteps = 5;  // of the alignment, before the base reports it
  for (const auto& [behind_first, state] : {std::pair(-1, TrackState::aligning),
                                            {0, TrackState::driving},
                                            {kSteps - 1, TrackState::driving},
                                            {kSteps, TrackState::aligning}})
  {
    SCOPED_TRACE(behind_first);
    Rig rig;
    for (int k = 0; k < 10; ++k) rig.step();
    ASSERT_EQ(rig.tracker.accept(sideways(rig.robot)), "");
    const std::uint32_t first = rig.step().command.sequence;
    rig.tamper = [](TrackInput& input) { input.wheels.aligned = false; };
    for (int k = 1; k < kSteps; ++k) ASSERT_EQ(rig.step().state, TrackState::aligning);
    ASSERT_EQ(rig.output.command.sequence, first + kSteps - 1);
    const std::uint32_t said = first + static_cast<std::uint32_t>(behind_first);
    rig.tamper = [said](TrackInput& input) {
      input.wheels.mode = Mode::lateral;
      input.wheels.aligned = true;
      input.wheels.sequence = said;
    };
    EXPECT_EQ(rig.step().state, state);
  }
}

/// The rig's clock, `seconds` later.
std::function<void(TrackInput&)> later(double seconds)
{
  return [seconds](TrackInput& input) {
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
  rig.tamper = [](TrackInput& input) { input.now = input.pose_stamp = input.wheels.stamp = 2000.0; };
  EXPECT_EQ(rig.step().command.sequence, 100000u);
  EXPECT_EQ(rig.step().command.sequence, 100001u) << "a clock that stands";
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
  rig.step_until([&] {
    seen.insert(rig.output.state);
    return is_resting(rig.output.state) && rig.output.state != TrackState::idle;
  });
  EXPECT_EQ(rig.output.state, TrackState::arrived) << rig.message;
  EXPECT_TRUE(seen.count(TrackState::stopping));
  EXPECT_LT(distance(rig.base.pose(), next.back().pose()), 0.01);
}

/// The planner has verified the trajectory from its first point on, not from a place beside it.
TEST(TrackerSequence, ATrajectoryThatBeginsElsewhereFails)
{
  const TrackOptions limits;
  for (const auto& [start, says] : {std::pair(Pose{1.0, 0.0, 0.0}, "begins 1.000 m and 0.000 rad from the robot"),
                                    {Pose{0.0, 1.1 * limits.xy_start_tolerance, 0.0}, "begins 0.033 m and 0.000 rad"},
                                    {Pose{0.0, 0.0, 1.1 * limits.yaw_start_tolerance}, "begins 0.000 m and 0.033 rad"}})
  {
    Rig rig;
    rig.step();
    ASSERT_EQ(rig.tracker.accept(sideways(rig.robot, start)), "");
    EXPECT_EQ(rig.step().state, TrackState::failed);
    EXPECT_NE(rig.message.find(says), std::string::npos) << rig.message;
    for (int k = 0; k < 50; ++k) EXPECT_EQ(rig.step().command.mode, Mode::none);
  }
}

TEST(TrackerSequence, ATrajectoryThatBeginsNearTheRobotIsDriven)
{
  const TrackOptions limits;
  for (const Pose& start :
       {Pose{0.0, 0.9 * limits.xy_start_tolerance, 0.0}, Pose{0.0, 0.0, -0.9 * limits.yaw_start_tolerance}})
  {
    Rig rig;
    ASSERT_EQ(rig.tracker.accept(sideways(rig.robot, start)), "");
    EXPECT_TRUE(rig.step_until(TrackState::arrived)) << rig.message;
  }
}

TEST(TrackerSequence, WhereATrajectoryBeginsIsJudgedOnceTheRobotRests)
{
  Rig rig;
  ASSERT_EQ(rig.tracker.accept(sideways(rig.robot)), "");
  ASSERT_TRUE(rig.step_until_fast());
  EXPECT_EQ(rig.tracker.accept(sideways(rig.robot, {5.0, 0.0, 0.0})), "");
  ASSERT_TRUE(rig.step_until(TrackState::failed));
  EXPECT_NE(rig.message.find("the trajectory begins "), std::string::npos) << rig.message;
}

/// The planner checks the rest of the trajectory from there on against new maps.
TEST(TrackerSequence, WhereItIsOnTheTrajectoryNeverGoesBack)
{
  Rig rig;
  const Trajectory trajectory = trajectory_of(
      rig.robot, {}, {{Mode::ackermann, 0.0, 1.0}, {Mode::lateral, 0.0, 1.0}, {Mode::ackermann, 0.0, 1.0}});
  ASSERT_EQ(rig.tracker.accept(trajectory), "");
  bool pushed = false;
  double before = 0.0;
  std::set<double> while_aligning;
  rig.step_until([&] {
    if (is_resting(rig.output.state)) return rig.output.state != TrackState::idle;
    EXPECT_GE(rig.output.t, before);
    before = rig.output.t;
    if (rig.output.state == TrackState::aligning) while_aligning.insert(rig.output.t);
    if (!pushed && rig.output.t > trajectory.back().t - 0.05)
    {
      rig.base.push(compose(rig.base.pose(), {0.0, 0.03, 0.0}));
      pushed = true;
    }
    return false;
  });
  EXPECT_EQ(rig.output.state, TrackState::arrived) << rig.message;
  EXPECT_EQ(while_aligning.size(), 4u) << "the three stretches' beginnings, and the end for the correction";
}

TEST(TrackerSequence, AStopKeepsWhereItWasOnTheTrajectory)
{
  for (const TrackState when : {TrackState::driving, TrackState::aligning})
  {
    Rig rig;
    ASSERT_EQ(
        rig.tracker.accept(trajectory_of(rig.robot, {}, {{Mode::ackermann, 0.0, 1.0}, {Mode::lateral, 0.0, 1.0}})), "");
    ASSERT_TRUE(rig.step_until([&] { return rig.output.t > 1.0 && rig.output.state == when; }));
    const double t = rig.output.t;
    rig.tracker.stop();
    while (rig.step().state == TrackState::stopping) EXPECT_EQ(rig.output.t, t);
    EXPECT_EQ(rig.output.state, TrackState::idle);
  }
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
  for (const Pose& push :
       {Pose{0.0, 0.045, 0.0}, Pose{-0.03, -0.03, 0.0}, Pose{0.0, 0.0, 0.09}, Pose{0.02, 0.03, -0.09}})
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

/// The space between there and where it should rest has not been checked for obstacles.
TEST(TrackerSequence, WhatIsFarFromAStretchsEndIsNotCorrected)
{
  for (const bool at_switch : {false, true})
    for (const Pose& push : {Pose{0.0, 0.08, 0.0}, Pose{0.0, 0.0, 0.15}})
    {
      Rig rig;
      std::vector<Piece> pieces = {{Mode::ackermann, 0.0, 2.0}};
      const double end = trajectory_of(rig.robot, {}, pieces).back().t;
      if (at_switch) pieces.push_back({Mode::lateral, 0.0, 1.0});
      ASSERT_EQ(rig.tracker.accept(trajectory_of(rig.robot, {}, pieces)), "");
      ASSERT_TRUE(rig.step_until([&] { return rig.output.t > end - 0.05; }));
      rig.base.push(compose(rig.base.pose(), push));
      ASSERT_TRUE(rig.step_until(TrackState::failed, 3.0));
      EXPECT_NE(rig.message.find("from where it should, too far to correct"), std::string::npos) << rig.message;
    }
}

TEST(TrackerSequence, AGoalThatCannotBeReachedIsGivenUpInBoundedTime)
{
  Rig rig;
  const Trajectory trajectory = trajectory_of(rig.robot, {}, {{Mode::ackermann, 0.0, 2.0}});
  ASSERT_EQ(rig.tracker.accept(trajectory), "");
  ASSERT_TRUE(rig.step_until([&] { return rig.output.t > trajectory.back().t - 0.05; }));
  rig.tamper = [](TrackInput& input) { input.pose = {2.0, 0.04, 0.0}; };  // it never gets nearer
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
