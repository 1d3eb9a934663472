#include "fourwis_navigation/track/tracker.h"

#include <gtest/gtest.h>

#include "../support/sentences.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"
#include "random_stretch.h"
#include "track/mpc.h"
#include "track_fixture.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 44;

/// The greatest errors of a drive.
struct Errors
{
  double lateral = 0.0, longitudinal = 0.0, heading = 0.0;
  std::vector<double> all;  ///< lateral ones, in the order in which they occurred
};

Errors drive(Rig& rig)
{
  Errors errors;
  rig.step_until([&] {
    if (rig.output.state == TrackState::driving)
    {
      errors.lateral = std::max(errors.lateral, std::abs(rig.output.lateral_error));
      errors.longitudinal = std::max(errors.longitudinal, std::abs(rig.output.longitudinal_error));
      errors.heading = std::max(errors.heading, std::abs(rig.output.heading_error));
      errors.all.push_back(rig.output.lateral_error);
    }
    return is_resting(rig.output.state);
  });
  return errors;
}

void expect_within_a_millimetre(const Pose& start, const Trajectory& trajectory)
{
  Rig rig(start);
  ASSERT_EQ(rig.tracker.accept(trajectory), "");
  const Errors errors = drive(rig);
  EXPECT_EQ(rig.output.state, TrackState::arrived) << rig.message;
  EXPECT_LT(errors.lateral, 1e-3);
  EXPECT_LT(errors.longitudinal, 1e-3);
  EXPECT_LT(errors.heading, 2e-3);
  EXPECT_LT(distance(rig.base.pose(), trajectory.back().pose()), 1.5e-3);
  EXPECT_LT(std::abs(rig.base.pose().theta - trajectory.back().theta), 2e-3);
}

TEST(Tracker, IdealWheelsKeepToLinesArcsCuspsAndSwitches)
{
  const Robot robot;
  const Pose start = {1.0, 2.0, 0.5};
  for (const std::vector<Piece>& pieces :
       std::vector<std::vector<Piece>>{{{Mode::ackermann, 0.0, 3.0}},
                                       {{Mode::ackermann, 0.3, 2.0}},
                                       {{Mode::ackermann, -0.4, -1.5}},
                                       {{Mode::lateral, 0.0, 2.0}},
                                       {{Mode::lateral, -0.3, -1.5}},
                                       {{Mode::parallel, 0.8, 2.0}},
                                       {{Mode::parallel, -1.5, -1.0}},
                                       {{Mode::ackermann, 0.3, 1.0}, {Mode::ackermann, 0.3, -1.0}},
                                       {{Mode::lateral, 0.2, -1.5},
                                        {Mode::ackermann, 0.1, 1.0},
                                        {Mode::parallel, 0.7, 1.0},
                                        {Mode::lateral, 0.0, 0.5}}})
    expect_within_a_millimetre(start, trajectory_of(robot, start, pieces));
}

TEST(Tracker, IdealWheelsKeepToRandomStretches)
{
  const Robot robot;
  Random random(kSeed);
  for (int trial = 0; trial < 30; ++trial)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
    const Trajectory trajectory = random_stretch(random, robot, random.mode());
    expect_within_a_millimetre(trajectory.front().pose(), trajectory);
  }
}

TEST(Tracker, TheMirrorImageIsDrivenLikeTheOriginal)
{
  const Robot robot;
  const Trajectory left = trajectory_of(robot, {}, {{Mode::ackermann, 0.3, 1.0}, {Mode::lateral, 0.2, 1.0}});
  Trajectory right = left;
  for (TrajectoryPoint& point : right)
  {
    point.y = -point.y;
    point.theta = -point.theta;
    // In lateral mode the mirror image has v < 0, and phi stays, because the turn changes its sense with v.
    if (point.mode == Mode::lateral)
      point.v = -point.v;
    else
      point.phi = -point.phi;
  }
  Rig original({0.0, 0.02, 0.0}), mirrored({0.0, -0.02, 0.0});
  ASSERT_EQ(original.tracker.accept(left), "");
  ASSERT_EQ(mirrored.tracker.accept(right), "");
  for (int k = 0; k < 400; ++k)
  {
    original.step();
    mirrored.step();
    ASSERT_EQ(original.output.state, mirrored.output.state) << k;
    EXPECT_NEAR(original.base.pose().x, mirrored.base.pose().x, 1e-4) << k;
    EXPECT_NEAR(original.base.pose().y, -mirrored.base.pose().y, 1e-4) << k;
  }
  EXPECT_EQ(original.output.state, TrackState::arrived);
}

TEST(Tracker, ReturnsFromBesideTheTrajectory)
{
  const Robot robot;
  for (const Mode mode : kPlannedModes)
    for (const Pose& push : {Pose{0.0, 0.1, 0.0}, Pose{-0.1, 0.0, 0.0}, Pose{0.0, 0.0, M_PI / 18}})
    {
      if (mode == Mode::parallel && push.theta != 0.0) continue;  // parallel motion cannot turn; the corrections can
      Rig rig;
      const Trajectory trajectory = trajectory_of(robot, {}, {{mode, 0.0, 5.0}});
      ASSERT_EQ(rig.tracker.accept(trajectory), "");
      ASSERT_TRUE(rig.step_until_fast(0.9));
      rig.base.push(compose(rig.base.pose(), push));
      const Errors errors = drive(rig);
      EXPECT_EQ(rig.output.state, TrackState::arrived) << rig.message;
      EXPECT_LT(errors.lateral, 0.105);
      EXPECT_LT(distance(rig.base.pose(), trajectory.back().pose()), 0.01);
    }
}

/// In reverse the direction of travel is opposite to the course.
TEST(Tracker, ErrorsAreToTheLeftAndAlongTheDirectionOfTravel)
{
  constexpr double kPush = 0.05, kNear = 0.01;
  for (const Mode mode : kPlannedModes)
    for (const double length : {5.0, -5.0})
    {
      SCOPED_TRACE(to_string(mode) + std::string(length > 0.0 ? " forward" : " backward"));
      const double travel = (mode == Mode::lateral ? M_PI_2 : 0.0) + (length > 0.0 ? 0.0 : M_PI);
      const auto pushed = [&](double along, double left, double turn) {
        Rig rig;
        EXPECT_EQ(rig.tracker.accept(trajectory_of(rig.robot, {}, {{mode, 0.0, length}})), "");
        EXPECT_TRUE(rig.step_until_fast(0.9));
        Pose pose = rig.base.pose();
        pose.x += std::cos(travel) * along - std::sin(travel) * left;
        pose.y += std::sin(travel) * along + std::cos(travel) * left;
        pose.theta += turn;
        rig.base.push(pose);
        TrackOutput output = rig.step();
        EXPECT_EQ(output.state, TrackState::driving) << rig.message;
        return output;
      };
      const TrackOutput beside = pushed(0.0, kPush, 0.0), ahead = pushed(kPush, 0.0, 0.0),
                        turned = pushed(0.0, 0.0, kPush);
      EXPECT_NEAR(beside.lateral_error, kPush, kNear);
      EXPECT_NEAR(beside.longitudinal_error, 0.0, kNear);
      EXPECT_NEAR(ahead.lateral_error, 0.0, kNear);
      EXPECT_NEAR(ahead.longitudinal_error, kPush, kNear);
      EXPECT_NEAR(turned.heading_error, kPush, kNear);
      EXPECT_NEAR(beside.heading_error, 0.0, kNear);
    }
}

TEST(Tracker, SaysTheSpeedAndTheSteeringAngleThatItCommands)
{
  for (const Mode mode : kPlannedModes)
  {
    Rig rig;
    ASSERT_EQ(rig.tracker.accept(trajectory_of(rig.robot, {}, {{mode, 0.2, -5.0}})), "");
    ASSERT_TRUE(rig.step_until_fast(0.9));
    const ModeMotion commanded = mode_motion(rig.robot, mode, rig.output.command.motion);
    EXPECT_NEAR(rig.output.speed, commanded.v, 0.05);
    EXPECT_NEAR(rig.output.phi, commanded.phi, 0.02);
    EXPECT_NEAR(rig.output.phi, 0.2, 0.05);
  }
}

TEST(Tracker, TwentyHertzWillDo)
{
  TrackOptions options = ideal_options();
  options.controller_frequency = 20.0;
  Rig rig({}, options);
  ASSERT_EQ(rig.tracker.accept(trajectory_of(rig.robot, {}, {{Mode::ackermann, 0.3, 2.0}, {Mode::lateral, 0.1, 1.0}})),
            "");
  const Errors errors = drive(rig);
  EXPECT_EQ(rig.output.state, TrackState::arrived) << rig.message;
  EXPECT_LT(errors.lateral, 3e-3);
  EXPECT_LT(errors.longitudinal, 5e-3);
}

TEST(Tracker, OnePointIsAlreadyThere)
{
  Rig rig;
  ASSERT_EQ(rig.tracker.accept({{0.0, Mode::ackermann, 0.0, 0.0, 0.0, 0.0, 0.0}}), "");
  EXPECT_TRUE(rig.step_until_rest());
  EXPECT_EQ(rig.output.state, TrackState::arrived);
}

TEST(Tracker, PredictsWhileDriving)
{
  Rig rig;
  EXPECT_TRUE(rig.tracker.prediction().empty());
  ASSERT_EQ(rig.tracker.accept(trajectory_of(rig.robot, {}, {{Mode::ackermann, 0.0, 3.0}})), "");
  ASSERT_TRUE(rig.step_until_fast());
  ASSERT_EQ(rig.tracker.prediction().size(), 26u);
  EXPECT_NEAR(rig.tracker.prediction().back().x - rig.tracker.prediction().front().x, 1.0, 0.1);
  ASSERT_TRUE(rig.step_until_rest());
  EXPECT_TRUE(rig.tracker.prediction().empty());
}

TEST(Tracker, TheSameCallsGiveTheSameAnswers)
{
  Rig one({0.01, 0.02, 0.03}), two({0.01, 0.02, 0.03});
  for (Rig* rig : {&one, &two})
    ASSERT_EQ(
        rig->tracker.accept(trajectory_of(rig->robot, {}, {{Mode::ackermann, 0.2, 1.0}, {Mode::parallel, 1.0, 1.0}})),
        "");
  for (int k = 0; k < 300; ++k)
  {
    const WheelCommand a = one.step().command, b = two.step().command;
    EXPECT_EQ(a.motion.angle, b.motion.angle);
    EXPECT_EQ(a.motion.speed, b.motion.speed);
    EXPECT_EQ(a.sequence, b.sequence);
  }
}

TEST(Tracker, RejectsOptionsAndRobotsOutOfRangeByName)
{
  TrackOptions options;
  options.lateral_scale = 0.0;
  const std::string said = "'lateral_scale' is 0, expected a number from 0.001 to 1000 m";
  EXPECT_TRUE(says(error_of<std::invalid_argument>([&] { Tracker(Robot(), options); }), said));
  EXPECT_TRUE(says(error_of<std::invalid_argument>([&] { Mpc(Robot(), options); }), said));
  Robot robot;
  robot.wheelbase = 1.1;
  EXPECT_TRUE(says(error_of<std::invalid_argument>([&] { Tracker(robot, TrackOptions()); }), "'wheelbase' is 1.1"));
}

TEST(Tracker, RejectsOptionsThatContradictTheRobotWithBothKeys)
{
  const auto said = [](auto change) {
    Robot robot;
    change(robot);
    return error_of<std::invalid_argument>([&] { Tracker(robot, TrackOptions()); });
  };
  const std::string late = said([](Robot& r) { r.wheel_max_rate = 0.4; });
  EXPECT_TRUE(says(late, "'alignment_timeout' is 5, expected at least 9.03 s"));
  EXPECT_TRUE(says(late, "'wheel_max_rate' is 0.4 rad/s"));
  EXPECT_TRUE(says(said([](Robot& r) { r.max_speed = 0.05; }),
                   "'correction_speed' is 0.1, expected at most 'max_speed' of the robot (0.05 m/s)"));
  EXPECT_TRUE(says(said([](Robot& r) { r.wheel_max_speed = 0.05; }), "'wheel_max_speed' of the robot (0.05 m/s)"));
}

}  // namespace
}  // namespace fourwis
