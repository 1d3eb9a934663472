#include "fourwis_navigation/vehicle/mode_traits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/random.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"
#include "fourwis_navigation/vehicle/wheels.h"

namespace fourwis
{
namespace
{

constexpr double kAccuracy = 1e-9;
constexpr unsigned kSeed = 41;

/// Robots of all proportions, so that no formula is right only because two lengths are alike.
struct Traits : testing::Test
{
  /// Visits each mode with many robots, speeds and steering angles that curve the way of no mode without end.
  template <class Visit>
  void for_motions(Visit visit)
  {
    for (const ModeName& entry : kModes)
      for (int k = 0; k < 200; ++k)
      {
        robot.wheelbase = random.between(0.2, 3.0);
        robot.track_width = random.between(0.2, 3.0);
        robot.max_steering_angle = random.between(0.1, 1.2);
        const double phi = random.between(-1.0, 1.0) * robot.max_steering_angle, v = random.between(-2.0, 2.0);
        SCOPED_TRACE(std::string(entry.name) + " at v " + std::to_string(v) + ", phi " + std::to_string(phi));
        visit(entry.mode, traits_of(entry.mode), v, phi);
      }
  }

  Random random{kSeed};
  Robot robot;
};

TEST_F(Traits, SayTheTwistOfTheBody)
{
  for_motions([&](Mode mode, const ModeTraits& traits, double v, double phi) {
    const double course = traits.follows_phi ? phi : traits.course.angle, speed = traits.translates ? v : 0.0;
    const double in_place = std::hypot(robot.wheelbase / 2.0, robot.track_width / 2.0);
    const double omega = traits.turns_with_phi() ? v * 2.0 * std::tan(phi) / (robot.*traits.base)
                         : traits.turns_in_place ? v / in_place
                                                 : 0.0;
    const Twist twist = body_twist(robot, mode, v, phi);
    EXPECT_NEAR(twist.vx, speed * std::cos(course), kAccuracy);
    EXPECT_NEAR(twist.vy, speed * std::sin(course), kAccuracy);
    EXPECT_NEAR(twist.omega, omega, kAccuracy);
  });
}

TEST_F(Traits, HaveExactCosinesAndSinesOfTheirCourses)
{
  for (const ModeTraits& traits : kModeTraits)
  {
    EXPECT_NEAR(traits.course.cosine, std::cos(traits.course.angle), 1e-16) << to_string(traits.mode);
    EXPECT_NEAR(traits.course.sine, std::sin(traits.course.angle), 1e-16) << to_string(traits.mode);
    EXPECT_EQ(std::hypot(traits.course.cosine, traits.course.sine), 1.0) << to_string(traits.mode);
  }
}

TEST_F(Traits, SayCurvatureItsSlopeAndTheTurningRadius)
{
  for_motions([&](Mode mode, const ModeTraits& traits, double v, double phi) {
    constexpr double h = 1e-6;
    const double kappa = curvature(robot, mode, phi);
    EXPECT_NEAR(body_twist(robot, mode, v, phi).omega, v * kappa, kAccuracy);
    const double in_place = traits.turns_in_place ? 1.0 / spin_radius(robot) : 0.0;
    EXPECT_NEAR(kappa, curvature_gain(robot, mode) * std::tan(phi) + in_place, kAccuracy);
    const double slope = (curvature(robot, mode, phi + h) - curvature(robot, mode, phi - h)) / (2.0 * h);
    EXPECT_NEAR(curvature_slope(robot, mode, phi), slope, 1e-5 * (1.0 + std::abs(slope)));
    // The point at that distance to the left of the course, or to its right, stands still.
    const Twist twist = body_twist(robot, mode, v, phi);
    const double radius = std::copysign(turning_radius(robot, mode, phi), kappa), course = fourwis::course(mode, phi);
    if (!std::isfinite(radius)) return;
    EXPECT_NEAR(twist.vx - twist.omega * radius * std::cos(course), 0.0, 1e-6);
    EXPECT_NEAR(twist.vy - twist.omega * radius * std::sin(course), 0.0, 1e-6);
  });
}

TEST_F(Traits, AllowAnArcInEveryMode)
{
  for_motions([&](Mode mode, const ModeTraits&, double v, double phi) {
    const Pose start = random.pose(3.0);
    const double duration = random.between(0.0, 2.0);
    const Pose moved = move(start, body_twist(robot, mode, v, phi), duration);
    const Pose arc = advance(robot, start, mode, phi, v * duration);
    EXPECT_NEAR(arc.x, moved.x, kAccuracy * 10.0);
    EXPECT_NEAR(arc.y, moved.y, kAccuracy * 10.0);
    EXPECT_NEAR(arc.theta, moved.theta, kAccuracy * 10.0);
  });
}

TEST_F(Traits, KnowHowFarTheAxesAreApartAlongTheCourseAndAcross)
{
  for_motions([&](Mode, const ModeTraits& traits, double, double) {
    EXPECT_EQ(traits.base == nullptr, traits.gauge == nullptr);
    if (!traits.turns_with_phi()) return;
    double along = 0.0, across = 0.0;
    for (const WheelPosition& axis : wheel_positions(robot))
    {
      along = std::max(along, 2.0 * (axis.x * traits.course.cosine + axis.y * traits.course.sine));
      across = std::max(across, 2.0 * (axis.y * traits.course.cosine - axis.x * traits.course.sine));
    }
    EXPECT_NEAR(along, robot.*traits.base, kAccuracy);
    EXPECT_NEAR(across, robot.*traits.gauge, kAccuracy);
  });
}

TEST_F(Traits, SayWhenPhiTurnsAllWheelsAlikeAndHalfATurnReversesTheMotion)
{
  for_motions([&](Mode mode, const ModeTraits& traits, double v, double phi) {
    if (traits.follows_phi)
    {
      for (double angle : wheel_angles(robot, mode, phi)) EXPECT_NEAR(angle, phi, kAccuracy);
      const Twist twist = body_twist(robot, mode, v, phi), other = body_twist(robot, mode, -v, phi + M_PI);
      EXPECT_NEAR(twist.vx, other.vx, kAccuracy);
      EXPECT_NEAR(twist.vy, other.vy, kAccuracy);
      EXPECT_EQ(twist.omega, 0.0);
    }
    else
    {
      EXPECT_EQ(course(mode, phi), course(mode, 0.0));
    }
  });
}

TEST_F(Traits, AreWhatTheWheelsShow)
{
  for_motions([&](Mode mode, const ModeTraits& traits, double v, double phi) {
    const ModeMotion motion = mode_motion(robot, mode, wheel_motion(robot, mode, v, phi));
    const bool moves = traits.translates || traits.turns_in_place;
    EXPECT_NEAR(motion.v, moves ? v : 0.0, 1e-6);
    EXPECT_NEAR(motion.phi, traits.translates ? phi : 0.0, 1e-6);
  });
}

TEST_F(Traits, LimitPhiByTheTravelOfTheWheelsOnlyWhereItTurnsThemAlike)
{
  for (const ModeTraits& traits : kModeTraits)
  {
    const double limit = traits.follows_phi ? robot.wheel_max_angle : robot.max_steering_angle;
    EXPECT_EQ(max_phi(robot, traits.mode), limit) << to_string(traits.mode);
  }
}

TEST_F(Traits, OfWhatIsNoModeAreThoseOfNone)
{
  for (int number : {static_cast<int>(kModeCount), 77, 255})
    EXPECT_EQ(traits_of(static_cast<Mode>(number)).mode, Mode::none) << number;
  EXPECT_FALSE(traits_of(Mode::none).translates || traits_of(Mode::none).turns_in_place);
}

TEST_F(Traits, FindTheModesThatTranslateAndTurnInPlace)
{
  EXPECT_TRUE(traits_of(kTranslation).follows_phi && traits_of(kTranslation).translates);
  EXPECT_TRUE(traits_of(kTurnInPlace).turns_in_place && !traits_of(kTurnInPlace).translates);
}

TEST_F(Traits, KnowWhetherASetOfModesCanTurn)
{
  EXPECT_FALSE(can_turn(ModeSet::none()));
  for (const ModeSet& modes : all_mode_sets())
  {
    bool turns = false;
    for (Mode mode : kPlannedModes) turns |= modes.contains(mode) && body_twist(robot, mode, 1.0, 0.3).omega != 0.0;
    EXPECT_EQ(can_turn(modes), turns) << text(modes);
  }
}

}  // namespace
}  // namespace fourwis
