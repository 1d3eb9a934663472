#include "fourwis_navigation/sim/body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "../support/random.h"
#include "../support/twist.h"
#include "fourwis_navigation/sim/plant.h"
#include "fourwis_navigation/vehicle/wheel_motion.h"
#include "fourwis_navigation/vehicle/wheel_twist.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 52;
constexpr DrivenWheels kAllDriven = {true, true, true, true};

struct BodyOnWheels : testing::Test
{
  Twist twist_on(const WheelMotion& wheels, const DrivenWheels& driven = kAllDriven, const SlipOptions& slip = {})
  {
    Body body(robot, slip);
    body.step(0.001, wheels, driven);
    return body.twist();
  }
  double steering(Mode mode) { return mode == Mode::spin ? 0.0 : random.steering(robot, mode); }

  testing::ScopedTrace trace{__FILE__, __LINE__, "seed " + std::to_string(kSeed)};
  Random random{kSeed};
  const Robot robot;
};

TEST_F(BodyOnWheels, MovesAsTheModeSays)
{
  for (int k = 0; k < 100; ++k)
    for (Mode mode : {Mode::ackermann, Mode::lateral, Mode::parallel, Mode::spin})
    {
      const double v = random.between(-1.0, 1.0), phi = steering(mode), duration = 0.8;
      const Pose start = random.pose(5.0);
      Body body(robot, {});
      body.place(start);
      for (int i = 0; i < 800; ++i) body.step(duration / 800, wheel_motion(robot, mode, v, phi), kAllDriven);
      const Pose expected = move(start, body_twist(robot, mode, v, phi), duration);
      ASSERT_LT(distance(body.pose(), expected), 1e-9) << to_string(mode) << v << " " << phi;
      ASSERT_NEAR(body.pose().theta, expected.theta, 1e-9);
    }
}

TEST_F(BodyOnWheels, ThatDisagreeMovesByTheTwistThatFitsBest)
{
  const WheelTwist fit(robot, {0.01, 1e3, 0.0});
  for (int k = 0; k < 100; ++k)
  {
    WheelMotion wheels;
    for (double& angle : wheels.angle) angle = random.angle();
    for (double& speed : wheels.speed) speed = random.between(-1.0, 1.0);
    expect_twist(twist_on(wheels), fit.estimate(wheels).twist, 1e-9);
  }
}

TEST_F(BodyOnWheels, IsDrivenByAnyOneOfThem)
{
  for (Mode mode : {Mode::ackermann, Mode::lateral, Mode::parallel, Mode::spin})
    for (std::size_t driving = 0; driving < kWheels; ++driving)
    {
      const double phi = steering(mode);
      WheelMotion wheels = wheel_motion(robot, mode, 0.6, phi);
      DrivenWheels driven{};
      driven[driving] = true;
      for (std::size_t i = 0; i < kWheels; ++i)
        if (!driven[i]) wheels.speed[i] = 99.0;  // does not matter
      SCOPED_TRACE(std::string(to_string(mode)) + ", wheel " + std::to_string(driving) + " drives");
      expect_twist(twist_on(wheels, driven), body_twist(robot, mode, 0.6, phi), 1e-6);
    }
}

TEST_F(BodyOnWheels, RollsTheWheelsThatAreNotDriven)
{
  for (Mode mode : {Mode::ackermann, Mode::lateral, Mode::parallel, Mode::spin})
  {
    const WheelMotion wheels = wheel_motion(robot, mode, 0.6, steering(mode));
    Body body(robot, {});
    body.step(0.001, wheels, kAllDriven);
    for (int i = 0; i < kWheels; ++i)
      EXPECT_NEAR(body.rolling_speed(i, wheels.angle[static_cast<std::size_t>(i)]),
                  wheels.speed[static_cast<std::size_t>(i)], 1e-9);
  }
}

TEST_F(BodyOnWheels, WithoutAnyDriveStandsStill)
{
  const Twist twist = twist_on(wheel_motion(robot, Mode::ackermann, 1.0, 0.3), {});
  EXPECT_EQ(std::hypot(twist.vx, twist.vy, twist.omega), 0.0);
}

TEST_F(BodyOnWheels, FallsBehindByTheShareThatDrivesSlip)
{
  SlipOptions slip;
  slip.drive_slip = 0.03;
  for (Mode mode : {Mode::ackermann, Mode::lateral, Mode::parallel, Mode::spin})
  {
    const double phi = steering(mode);
    expect_twist(twist_on(wheel_motion(robot, mode, 1.0, phi), kAllDriven, slip), body_twist(robot, mode, 0.97, phi),
                 1e-12);
  }
}

TEST_F(BodyOnWheels, IsCarriedOutOfACurveByLateralSlip)
{
  SlipOptions slip;
  slip.lateral_slip = 0.02;
  for (double v : {1.0, -1.0})
    for (double phi : {0.3, -0.3})
    {
      Body body(robot, slip);
      for (int i = 0; i < 100; ++i) body.step(0.001, wheel_motion(robot, Mode::ackermann, v, phi), kAllDriven);
      const Twist twist = body.twist();
      const double inward = v * twist.omega;  // the lateral acceleration, > 0 to the left
      EXPECT_LT(twist.vy * inward, 0.0);
      EXPECT_NEAR(std::abs(twist.vy), 0.02 * std::abs(inward), 0.2 * 0.02 * std::abs(inward));
    }
}

TEST_F(BodyOnWheels, DoesNotSlipSidewaysOnAStraightLine)
{
  SlipOptions slip;
  slip.lateral_slip = 0.02;
  expect_twist(twist_on(wheel_motion(robot, Mode::parallel, 1.0, 0.4), kAllDriven, slip),
               body_twist(robot, Mode::parallel, 1.0, 0.4), 1e-12);
}

TEST_F(BodyOnWheels, RejectsInvalidOptions)
{
  EXPECT_THROW(Body(robot, {1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(Body(robot, {NAN, 0.0}), std::invalid_argument);
  Robot unusable;
  unusable.length = NAN;
  EXPECT_THROW(Body(unusable, {}), std::invalid_argument);
  EXPECT_THROW(Plant(unusable, {}, {}), std::invalid_argument);
  EXPECT_THROW(Body(robot, {0.0, -0.1}), std::invalid_argument);
}

}  // namespace
}  // namespace fourwis
