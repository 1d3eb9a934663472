// Without permission the robot comes to rest on its way; with it, it goes on.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../support/grids.h"
#include "../support/random.h"
#include "fourwis_navigation/planner/planner.h"
#include "simulator_rig.h"

namespace fourwis
{
namespace
{

constexpr double kForever = std::numeric_limits<double>::infinity();
const Pose kStart{2, 2, 0}, kGoal{12, 7, 1.2};

/// A robot with its usual lags on a way of some 12 m, whose permission the test decides.
struct Permission : testing::Test
{
  Permission()
  {
    const PlannerOptions options;
    trajectory =
        Planner(options).plan(World(free_area(16.0, 12.0, 0.05), robot, options), {kStart, kGoal, {}}).trajectory;
    base.place(kStart);
    EXPECT_EQ(tracker.accept(trajectory), "");
  }

  /// One control step.
  void step()
  {
    output = tracker.step({base.time(), base.time(), base.pose(), base.wheels(), permission});
    message = std::string(output.message);
    base.command(output.command);
    base.step(0.02);
    farthest = std::max(farthest, std::abs(output.lateral_error));
  }
  void steps(double duration)
  {
    for (double end = base.time() + duration; base.time() < end;) step();
  }
  double speed() const { return std::abs(output.speed); }
  bool says(const std::string& part) const { return message.find(part) != std::string::npos; }

  void expect_arrival()
  {
    for (double end = base.time() + 60.0; output.state != TrackState::arrived && base.time() < end;)
    {
      step();
      ASSERT_NE(output.state, TrackState::failed) << message;
    }
    EXPECT_LT(distance(base.pose(), kGoal), 0.01);
  }

  const Robot robot;
  Trajectory trajectory;
  BaseSimulator base{robot, {}};
  Tracker tracker{robot, {}};
  TrackOutput output;
  DrivePermission permission;
  std::string message;
  double farthest = 0.0;  ///< from the trajectory, aside [m]
};

TEST_F(Permission, IsNeededToBegin)
{
  permission = {-kForever, kForever};
  steps(8.0);  // longer than any alignment may take
  EXPECT_LT(distance(base.pose(), kStart), 1e-6);
  EXPECT_EQ(output.state, TrackState::aligning);
  EXPECT_TRUE(says("no permission to drive has come")) << message;
  permission = {};
  expect_arrival();
}

TEST_F(Permission, ThatIsTooOldStopsTheRobotOnItsWayUntilItComesAgain)
{
  while (speed() < 0.98 * robot.max_speed) step();
  permission.age = 0.29;
  steps(0.5);
  EXPECT_GT(speed(), 0.9 * robot.max_speed);
  permission.age = 0.31;
  const Pose before = base.pose();
  steps(1.0);
  EXPECT_EQ(output.state, TrackState::driving);
  EXPECT_TRUE(says("the permission to drive is 0.310 s old, permit_timeout is 0.300 s")) << message;
  // Latency, lag and one step, then v^2 / 2a.
  EXPECT_LT(distance(base.pose(), before), 1.0 * (0.02 + 0.03 + 0.02) + 1.0 / (2.0 * robot.max_acceleration) + 0.05);
  const Pose there = base.pose();
  steps(20.0);
  EXPECT_LT(distance(base.pose(), there), 1e-3);
  EXPECT_EQ(output.state, TrackState::driving);
  permission.age = 0.0;
  expect_arrival();
  EXPECT_LT(farthest, 0.015) << "it stays on its way";
}

/// A correction of the localisation, or a push, is no reason to move.
TEST_F(Permission, IsNeededToMakeUpForACorrectionOfThePose)
{
  for (double jump : {0.2, -0.2})
  {
    while (speed() < 0.98 * robot.max_speed) step();
    permission.age = 1.0;
    steps(2.0);
    base.place(compose(base.pose(), {jump, 0.0, 0.0}));
    const Pose there = base.pose();
    steps(3.0);
    EXPECT_EQ(output.state, TrackState::driving) << message;
    EXPECT_LT(distance(base.pose(), there), 1e-3);
    permission.age = 0.0;
    steps(1.5);
  }
  expect_arrival();
}

TEST_F(Permission, IsWaitedForWithoutATimeoutOfAlignment)
{
  permission = {-kForever, kForever};
  steps(7.0);
  ASSERT_EQ(output.state, TrackState::aligning);
  WheelState noisy = base.wheels();
  noisy.aligned = false;
  output = tracker.step({base.time(), base.time(), base.pose(), noisy, permission});
  EXPECT_EQ(output.state, TrackState::aligning) << output.message;
}

/// At any time: in curves, at cusps and switches, while it begins.
TEST_F(Permission, MayGoAndComeAtAnyTime)
{
  Random random(12);
  for (double until = 0.0; output.state != TrackState::arrived && base.time() < 120.0;)
  {
    if (base.time() >= until)
    {
      permission.age = permission.age == 0.0 ? 1.0 : 0.0;
      until = base.time() + random.between(0.02, 0.8);
    }
    step();
    ASSERT_NE(output.state, TrackState::failed) << message;
    ASSERT_LT(std::abs(output.longitudinal_error), 0.1);
  }
  EXPECT_EQ(output.state, TrackState::arrived);
  EXPECT_LT(farthest, 0.02);
}

TEST_F(Permission, EndsWhereTheWayIsNotKnownToBeFree)
{
  for (double until : {1.0, 3.0, 6.5})
  {
    permission.free_until = until;
    steps(12.0);
    EXPECT_EQ(output.state, TrackState::driving);
    EXPECT_TRUE(says("free until")) << message;
    EXPECT_LE(output.t, until + 1e-6);
    EXPECT_GT(output.t, until - 0.35) << "it drives as far as it may";
    EXPECT_LT(speed(), 1e-3);
  }
  permission = {};
  expect_arrival();
}

TEST_F(Permission, ThatIsNoNumberIsNone)
{
  permission.free_until = std::nan("");
  steps(2.0);
  EXPECT_LT(distance(base.pose(), kStart), 1e-6);
  permission = {kForever, std::nan("")};
  steps(2.0);
  EXPECT_LT(distance(base.pose(), kStart), 1e-6);
}

/// What has been checked is the way itself.
TEST_F(Permission, ForAllOfTheWayIsNeededToCorrectAtItsEnd)
{
  while (output.state != TrackState::arrived && base.time() < 60.0) step();
  ASSERT_EQ(output.state, TrackState::arrived);
  base.place({kGoal.x - 0.03, kGoal.y, kGoal.theta});
  TrajectoryPoint only = trajectory.back();
  only.t = 0.0;
  ASSERT_EQ(tracker.accept({only}), "");
  permission = {-kForever, kForever};
  const Pose there = base.pose();
  steps(4.0);
  EXPECT_LT(distance(base.pose(), there), 1e-4);
  permission = {};
  expect_arrival();
}

}  // namespace
}  // namespace fourwis
