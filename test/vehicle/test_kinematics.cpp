#include "fourwis_navigation/vehicle/kinematics.h"

#include <gtest/gtest.h>

#include <vector>

#include "../support/drive.h"
#include "../support/random.h"

namespace fourwis
{
namespace
{

constexpr double kAccuracy = 1e-9;
constexpr unsigned kSeed = 2;

/// A motion with phi held.
struct Motion
{
  Mode mode;
  Pose start;
  double phi, length;
};

std::string text(const Motion& motion)
{
  return std::string(to_string(motion.mode)) + " from " + text(motion.start) + " phi " + std::to_string(motion.phi) +
         " length " + std::to_string(motion.length);
}

struct Kinematics : testing::Test
{
  Kinematics()
  {
    Random random(kSeed);
    for (int k = 0; k < 500; ++k)
    {
      const Mode mode = random.mode();
      motions.push_back({mode, random.pose(5.0), random.steering(robot, mode), random.between(-4.0, 4.0)});
    }
    // Where the formulas change: no or hardly any curvature, no or hardly any length, full lock.
    for (Mode mode : kPlannedModes)
      for (double phi : {0.0, 1e-300, 1e-12, -1e-6, 3e-4, -1e-3, robot.max_steering_angle, -robot.max_steering_angle})
        for (double length : {0.0, 1e-12, -1e-6, 1e-3, -0.3, 3.0})
          motions.push_back({mode, random.pose(5.0), phi, length});
  }

  Pose end_of(const Motion& motion) const
  {
    return advance(robot, motion.start, motion.mode, motion.phi, motion.length);
  }

  static void expect_near(const Pose& a, const Pose& b)
  {
    EXPECT_NEAR(a.x, b.x, kAccuracy);
    EXPECT_NEAR(a.y, b.y, kAccuracy);
    EXPECT_NEAR(a.theta, b.theta, kAccuracy);
  }

  const Robot robot;
  std::vector<Motion> motions;
};

TEST_F(Kinematics, TheArcIsTheIntegralOfTheBodyTwist)
{
  for (const Motion& motion : motions)
  {
    SCOPED_TRACE(text(motion));
    expect_near(end_of(motion), drive_numerically(robot, motion.start, motion.mode, motion.phi, motion.length));
  }
}

TEST_F(Kinematics, TwoArcsAfterAnotherAreOne)
{
  for (const Motion& motion : motions)
    for (double share : {-0.7, 0.01, 0.5, 1.8})
    {
      SCOPED_TRACE(text(motion));
      const Pose between = advance(robot, motion.start, motion.mode, motion.phi, share * motion.length);
      expect_near(advance(robot, between, motion.mode, motion.phi, (1.0 - share) * motion.length), end_of(motion));
    }
}

TEST_F(Kinematics, DrivingBackLeadsBackToTheStart)
{
  for (const Motion& motion : motions)
  {
    SCOPED_TRACE(text(motion));
    expect_near(advance(robot, end_of(motion), motion.mode, motion.phi, -motion.length), motion.start);
  }
}

TEST_F(Kinematics, TheStartPoseMovesTheWholeArc)
{
  for (const Motion& motion : motions)
  {
    SCOPED_TRACE(text(motion));
    expect_near(end_of(motion), compose(motion.start, advance(robot, {}, motion.mode, motion.phi, motion.length)));
  }
}

TEST_F(Kinematics, AnArcGivesPosesCosinesAndSinesOfOneMotion)
{
  for (const Motion& motion : motions)
  {
    SCOPED_TRACE(text(motion));
    const Arc arc(robot, motion.start, motion.mode, motion.phi);
    const Arc::Placement placement = arc.at(motion.length);
    const Pose pose = arc.pose(motion.length);
    expect_near(pose, end_of(motion));
    expect_near({placement.x, placement.y, 0.0}, {pose.x, pose.y, 0.0});
    EXPECT_NEAR(placement.cosine, std::cos(pose.theta), kAccuracy);
    EXPECT_NEAR(placement.sine, std::sin(pose.theta), kAccuracy);
  }
}

TEST_F(Kinematics, CurvatureIsTheTurnForEachMetre)
{
  for (const Motion& motion : motions)
  {
    const double kappa = curvature(robot, motion.mode, motion.phi);
    SCOPED_TRACE(text(motion));
    EXPECT_NEAR(end_of(motion).theta - motion.start.theta, kappa * motion.length, kAccuracy);
    EXPECT_EQ(Arc(robot, motion.start, motion.mode, motion.phi).curvature(), kappa);
    EXPECT_LE(std::abs(kappa), max_curvature(robot, motion.mode));
  }
}

TEST_F(Kinematics, TheCourseIsTheDirectionTheTwistPointsTo)
{
  for (const Motion& motion : motions)
  {
    SCOPED_TRACE(text(motion));
    const Twist twist = body_twist(robot, motion.mode, 1.0, motion.phi);
    EXPECT_NEAR(heading_gap(std::atan2(twist.vy, twist.vx), course(motion.mode, motion.phi)), 0.0, kAccuracy);
  }
}

TEST_F(Kinematics, TheTwistIsProportionalToSpeedAndCMovesAtThatSpeed)
{
  for (const Motion& motion : motions)
    for (double v : {-2.0, -0.3, 0.0, 1.5})
    {
      SCOPED_TRACE(text(motion));
      const Twist unit = body_twist(robot, motion.mode, 1.0, motion.phi);
      const Twist twist = body_twist(robot, motion.mode, v, motion.phi);
      EXPECT_NEAR(std::hypot(twist.vx, twist.vy), std::abs(v), kAccuracy);
      EXPECT_NEAR(twist.vx, v * unit.vx, kAccuracy);
      EXPECT_NEAR(twist.vy, v * unit.vy, kAccuracy);
      EXPECT_NEAR(twist.omega, v * unit.omega, kAccuracy);
    }
}

TEST_F(Kinematics, AckermannDrivesForwardLateralToTheLeftParallelWhereTheWheelsPoint)
{
  expect_near(advance(robot, {}, Mode::ackermann, 0.0, 2.0), {2.0, 0.0, 0.0});
  expect_near(advance(robot, {}, Mode::lateral, 0.0, 2.0), {0.0, 2.0, 0.0});
  expect_near(advance(robot, {}, Mode::parallel, M_PI / 6.0, 2.0), {std::sqrt(3.0), 1.0, 0.0});
}

TEST_F(Kinematics, PositivePhiTurnsLeftInBothTurningModes)
{
  for (Mode mode : {Mode::ackermann, Mode::lateral}) EXPECT_GT(advance(robot, {}, mode, 0.1, 0.1).theta, 0.0);
}

TEST_F(Kinematics, ParallelMotionNeverTurns)
{
  for (double phi : {0.0, 0.4, -1.2, M_PI_2, M_PI})
    EXPECT_EQ(advance(robot, {1.0, 2.0, 0.3}, Mode::parallel, phi, -3.0).theta, 0.3);
}

TEST_F(Kinematics, TheGreatestCurvaturesAreThoseOfThePaper)
{
  EXPECT_NEAR(max_curvature(robot, Mode::ackermann), 1.698, 5e-4);
  EXPECT_NEAR(max_curvature(robot, Mode::lateral), 2.220, 1e-3);
  EXPECT_EQ(max_curvature(robot, Mode::parallel), 0.0);
}

TEST_F(Kinematics, SpinTurnsInPlaceAndNoneStandsStill)
{
  const Twist spin = body_twist(robot, Mode::spin, 0.5, 0.2), none = body_twist(robot, Mode::none, 1.0, 0.2);
  EXPECT_EQ(std::hypot(spin.vx, spin.vy), 0.0);
  EXPECT_NEAR(spin.omega * std::hypot(robot.wheelbase / 2.0, robot.track_width / 2.0), 0.5, kAccuracy);
  EXPECT_EQ(std::hypot(none.vx, none.vy, none.omega), 0.0);
}

TEST_F(Kinematics, MovingWithTheTwistOfAModeIsItsArc)
{
  for (const Motion& motion : motions)
  {
    SCOPED_TRACE(text(motion));
    const double speed = 0.7;
    expect_near(move(motion.start, body_twist(robot, motion.mode, speed, motion.phi), motion.length / speed),
                end_of(motion));
  }
}

TEST_F(Kinematics, MovingWithAnyTwistIsTheLimitOfSmallSteps)
{
  Random random(kSeed);
  for (int k = 0; k < 50; ++k)
  {
    const Pose start = random.pose(5.0);
    const Twist twist = {random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-2.0, 2.0)};
    constexpr int kSteps = 20000;
    const double duration = random.between(0.0, 2.0), dt = duration / kSteps;
    Pose pose = start;
    for (int i = 0; i < kSteps; ++i) pose = compose(pose, {twist.vx * dt, twist.vy * dt, twist.omega * dt});
    const Pose moved = move(start, twist, duration);
    EXPECT_LT(distance(moved, pose), 1e-3);
    EXPECT_NEAR(moved.theta, pose.theta, kAccuracy);
  }
}

}  // namespace
}  // namespace fourwis
