// For every reason to stop, the robot brakes along its curve, comes to rest, and reports the reason.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fourwis_navigation/vehicle/wheels.h"
#include "track_fixture.h"

namespace fourwis
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct Failure
{
  const char* says;
  std::function<void(TrackInput&)> tamper;
};

/// Faults of the input.
std::vector<Failure> unusable_inputs()
{
  return {
      {"the robot's pose is not known", [](TrackInput& input) { input.pose.x = kNaN; }},
      {"the robot's pose is not known", [](TrackInput& input) { input.pose_stamp = kNaN; }},
      {"the time is no number", [](TrackInput& input) { input.now = kNaN; }},
      {"the wheels' state holds something that is no number",
       [](TrackInput& input) { input.wheels.motion.speed[2] = kNaN; }},
      {"the wheels' state holds something that is no number", [](TrackInput& input) { input.wheels.stamp = INFINITY; }},
      {"the pose is 0.500 s old, pose_timeout is 0.100 s",
       [](TrackInput& input) { input.pose_stamp = input.now - 0.5; }},
      {"the pose's stamp lies 0.500 s ahead", [](TrackInput& input) { input.pose_stamp = input.now + 0.5; }},
      {"the wheels' state is 0.500 s old, wheel_state_timeout is 0.100 s",
       [](TrackInput& input) { input.wheels.stamp = input.now - 0.5; }},
      {"the stamp of the wheels' state lies 0.500 s ahead",
       [](TrackInput& input) { input.wheels.stamp = input.now + 0.5; }},
      {"the base is not ready", [](TrackInput& input) { input.wheels.state = BaseState::not_ready; }},
      {"the base is not enabled", [](TrackInput& input) { input.wheels.state = BaseState::ready; }},
      {"the base stops by itself", [](TrackInput& input) { input.wheels.state = BaseState::stopping; }},
      {"the base has a fault", [](TrackInput& input) { input.wheels.state = BaseState::fault; }},
      {"the base's state is unknown", [](TrackInput& input) { input.wheels.state = BaseState(77); }},
  };
}

/// A robot or a wheel that is away from where it should be.
std::vector<Failure> deviations()
{
  return {
      {"the robot is 0.2",
       [](TrackInput& input) {
         input.pose = compose(input.pose, {0.0, 0.2, 0.0});
       }},
      {"from where it should be on the trajectory",
       [](TrackInput& input) {
         input.pose = compose(input.pose, {-0.5, 0.0, 0.0});
       }},
      {"the robot's heading is off by 0.4", [](TrackInput& input) { input.pose.theta += 0.4; }},
      {"the rear left wheel is ", [](TrackInput& input) { input.wheels.motion.angle[2] += 0.5; }},
  };
}

std::vector<Failure> failures()
{
  std::vector<Failure> all = unusable_inputs();
  for (const Failure& failure : deviations()) all.push_back(failure);
  return all;
}

Trajectory long_arc(const Robot& robot)
{
  return trajectory_of(robot, {}, {{Mode::ackermann, 0.2, 8.0}});
}

/// The commanded speed of the rear right wheel.
double told_speed(const Rig& rig)
{
  return rig.output.command.motion.speed[3];
}

/// Drives fast, causes the fault, and goes on until the tracker has noticed it.
void drive_into(Rig& rig, const Failure& failure)
{
  ASSERT_EQ(rig.tracker.accept(long_arc(rig.robot)), "");
  ASSERT_TRUE(rig.step_until_fast(0.9));
  rig.tamper = failure.tamper;
  ASSERT_TRUE(rig.step_until(TrackState::stopping, 1.0));
}

/// The wheels differ by less from where they stand on the arc while a stop begins [rad]. Straight ones would by 0.17 or more.
constexpr double kSteeringOfAStop = 0.1;

TEST(TrackerStops, EveryReasonIsNamedAndEndsAtRest)
{
  for (const Failure& failure : failures())
  {
    SCOPED_TRACE(failure.says);
    Rig rig;
    ASSERT_NO_FATAL_FAILURE(drive_into(rig, failure));
    EXPECT_NE(rig.message.find(failure.says), std::string::npos) << rig.message;
    ASSERT_TRUE(rig.step_until(TrackState::failed, 3.0));
    EXPECT_NE(rig.message.find(failure.says), std::string::npos) << rig.message;
    EXPECT_EQ(rig.output.command.mode, Mode::none);
    EXPECT_EQ(told_speed(rig), 0.0);
  }
}

TEST(TrackerStops, BrakesAtMaxAccelerationWithSteeringHeld)
{
  for (const Failure& failure : failures())
  {
    SCOPED_TRACE(failure.says);
    Rig rig;
    ASSERT_NO_FATAL_FAILURE(drive_into(rig, failure));
    const PerWheel angles = rig.output.command.motion.angle, on_the_arc = wheel_angles(rig.robot, Mode::ackermann, 0.2);
    for (std::size_t i = 0; i < kWheels; ++i) EXPECT_NEAR(angles[i], on_the_arc[i], kSteeringOfAStop);
    double speed = told_speed(rig);
    const double ratio = rig.output.command.motion.speed[0] / speed;
    int steps = 0;
    for (; rig.output.command.mode != Mode::none; ++steps)
    {
      EXPECT_EQ(rig.output.command.motion.angle, angles);
      EXPECT_NEAR(rig.output.phi, 0.2, kSteeringOfAStop);
      EXPECT_NEAR(rig.output.command.motion.speed[0], ratio * told_speed(rig), 1e-9);
      rig.step();
      EXPECT_LT(told_speed(rig), speed);
      EXPECT_GE(told_speed(rig), speed - 1.4 * rig.robot.max_acceleration * rig.period);
      speed = told_speed(rig);
    }
    EXPECT_GE(steps, 8);  // 1 m/s at 5 m/s^2
    EXPECT_LE(steps, 10);
    EXPECT_EQ(rig.output.command.motion.angle, angles);
  }
}

/// A robot that is held back must not be driven with more speed.
TEST(TrackerStops, BrakesFromTheSpeedThatIsMeasured)
{
  for (const double measured : {0.3, -0.2})
  {
    SCOPED_TRACE(measured);
    Rig rig;
    ASSERT_EQ(rig.tracker.accept(trajectory_of(rig.robot, {}, {{Mode::ackermann, 0.0, 8.0}})), "");
    ASSERT_TRUE(rig.step_until_fast(0.9));
    rig.tamper = [&](TrackInput& input) { input.wheels.motion.speed.fill(measured); };
    rig.tracker.stop();
    rig.step();
    EXPECT_LE(told_speed(rig), std::max(0.0, measured));
    EXPECT_GE(told_speed(rig), 0.0);
    EXPECT_EQ(rig.output.state, TrackState::stopping);
  }
}

TEST(TrackerStops, BrakesAsHardWhenStepsAreFarApart)
{
  Rig rig;
  ASSERT_EQ(rig.tracker.accept(trajectory_of(rig.robot, {}, {{Mode::ackermann, 0.0, 8.0}})), "");
  ASSERT_TRUE(rig.step_until_fast(0.9));
  rig.tracker.stop();
  const double speed = told_speed(rig);
  rig.clock += 0.08;
  rig.step();
  EXPECT_NEAR(told_speed(rig), speed - rig.robot.max_acceleration * 0.1, 1e-3);
}

TEST(TrackerStops, AFailureWhileAligningDrivesNothing)
{
  for (const Failure& failure : unusable_inputs())
  {
    SCOPED_TRACE(failure.says);
    Rig rig;
    ASSERT_EQ(rig.tracker.accept(trajectory_of(rig.robot, {}, {{Mode::lateral, 0.0, 2.0}})), "");
    ASSERT_TRUE(rig.step_until(TrackState::aligning, 1.0));
    rig.tamper = failure.tamper;
    rig.step();
    EXPECT_EQ(rig.output.command.mode, Mode::none);
    ASSERT_TRUE(rig.step_until(TrackState::failed, 3.0));
    EXPECT_NE(rig.message.find(failure.says), std::string::npos) << rig.message;
    EXPECT_EQ(rig.base.pose().x, 0.0);
  }
}

TEST(TrackerStops, AFailureAtTheStartStartsNothing)
{
  for (const Failure& failure : unusable_inputs())
  {
    SCOPED_TRACE(failure.says);
    Rig rig;
    rig.tamper = failure.tamper;
    rig.step();
    EXPECT_EQ(rig.output.state, TrackState::idle);
    EXPECT_EQ(rig.tracker.accept(long_arc(rig.robot)), "");
    rig.step();
    EXPECT_EQ(rig.output.state, TrackState::failed);
    EXPECT_NE(rig.message.find(failure.says), std::string::npos) << rig.message;
    rig.tamper = {};
    for (int k = 0; k < 50; ++k) EXPECT_EQ(rig.step().command.mode, Mode::none);  // and it is not resumed
  }
}

TEST(TrackerStops, ClocksThatJump)
{
  for (const double jump : {-5.0, -0.03, 0.5, 1e6})
  {
    SCOPED_TRACE(jump);
    Rig rig;
    ASSERT_EQ(rig.tracker.accept(long_arc(rig.robot)), "");
    ASSERT_TRUE(rig.step_until_fast(0.9));
    rig.clock += jump;
    rig.step();
    EXPECT_EQ(rig.output.state, TrackState::stopping);
    EXPECT_NE(rig.message.find("the clock went on by "), std::string::npos) << rig.message;
    ASSERT_TRUE(rig.step_until(TrackState::failed, 3.0));
    EXPECT_EQ(rig.output.command.mode, Mode::none);
  }
}

TEST(TrackerStops, AClockThatStandsIsNoReason)
{
  Rig rig;
  ASSERT_EQ(rig.tracker.accept(long_arc(rig.robot)), "");
  ASSERT_TRUE(rig.step_until_fast(0.9));
  const TrackInput input = {rig.base.wheels().stamp, rig.base.wheels().stamp, rig.base.pose(), rig.base.wheels()};
  for (int k = 0; k < 3; ++k) EXPECT_EQ(rig.tracker.step(input).state, TrackState::driving);
  EXPECT_TRUE(rig.step_until(TrackState::arrived));
}

TEST(TrackerStops, WheelsThatNeverAlign)
{
  Rig rig;
  ASSERT_EQ(rig.tracker.accept(trajectory_of(rig.robot, {}, {{Mode::lateral, 0.0, 2.0}})), "");
  rig.tamper = [](TrackInput& input) { input.wheels.aligned = false; };
  ASSERT_TRUE(rig.step_until(TrackState::failed, 6.0));
  EXPECT_NE(rig.message.find("the wheels are not aligned after 5.0"), std::string::npos) << rig.message;
  EXPECT_EQ(rig.base.pose().y, 0.0);
}

TEST(TrackerStops, WheelsThatCannotTurnSoFar)
{
  Robot robot;
  robot.wheel_max_angle = M_PI / 3.0;
  Tracker tracker(robot, ideal_options());
  IdealBase base(robot, {});
  ASSERT_EQ(tracker.accept(trajectory_of(robot, {}, {{Mode::lateral, 0.0, 1.0}})), "");
  const TrackOutput output = tracker.step({0.0, 0.0, base.pose(), base.wheels()});
  EXPECT_EQ(output.state, TrackState::failed);
  EXPECT_NE(output.message.find("beyond its travel"), std::string::npos) << output.message;
}

TEST(TrackerStops, WheelsThatDoNotComeToRest)
{
  Rig rig;
  ASSERT_EQ(rig.tracker.accept(trajectory_of(rig.robot, {}, {{Mode::ackermann, 0.0, 1.0}})), "");
  ASSERT_TRUE(rig.step_until_fast(0.9));
  rig.tamper = [](TrackInput& input) { input.wheels.motion.speed[1] = 0.5; };
  ASSERT_TRUE(rig.step_until(TrackState::failed));
  EXPECT_NE(rig.message.find("the wheels do not come to rest"), std::string::npos) << rig.message;
}

TEST(TrackerStops, ToldToStopItForgetsTheTrajectory)
{
  Rig rig;
  ASSERT_EQ(rig.tracker.accept(long_arc(rig.robot)), "");
  ASSERT_TRUE(rig.step_until_fast(0.9));
  EXPECT_EQ(rig.tracker.accept({}), "");
  rig.step();
  EXPECT_EQ(rig.output.state, TrackState::stopping);
  EXPECT_EQ(rig.message, "told to stop");
  ASSERT_TRUE(rig.step_until(TrackState::idle, 3.0));
  EXPECT_EQ(rig.message, "");
  const Pose rest = rig.base.pose();
  for (int k = 0; k < 50; ++k) rig.step();
  EXPECT_EQ(distance(rig.base.pose(), rest), 0.0);
}

}  // namespace
}  // namespace fourwis
