// The referee has its own formulas for every mode. Here they are compared with those of the stage `vehicle`.

#include <cmath>

#include <gtest/gtest.h>

#include "../support/random.h"
#include "fourwis_navigation/referee/referee.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/mode_traits.h"
#include "fourwis_navigation/vehicle/wheels.h"
#include "referee/rollout.h"
#include "referee/wheels.h"
#include "referee_tour.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 43;
constexpr double kAccuracy = 1e-6;

struct ModesOfTheReferee : testing::TestWithParam<Mode>
{
  /// Robots of all proportions with a steering angle each.
  template <class Visit>
  void for_steering_angles(Visit visit)
  {
    for (int k = 0; k < 200; ++k)
    {
      robot.wheelbase = random.between(0.3, 2.0);
      robot.track_width = random.between(0.3, 2.0);
      const double phi = random.steering(robot, GetParam());
      SCOPED_TRACE("wheelbase " + std::to_string(robot.wheelbase) + ", track " + std::to_string(robot.track_width) +
                   ", phi " + std::to_string(phi));
      visit(phi);
    }
  }

  Random random{kSeed};
  Robot robot;
};

TEST_P(ModesOfTheReferee, HaveTheCourseAndCurvatureOfTheVehicle)
{
  for_steering_angles([&](double phi) {
    const Pose start = random.pose(3.0);
    const double v = random.between(-1.0, 1.0);
    const TrajectoryPoint from{0.0, GetParam(), start.x, start.y, start.theta, v, phi, 0.0, 0.0};
    TrajectoryPoint to = from;
    to.t = 1.5;
    referee::Rollout rollout(robot, from, to);
    EXPECT_NEAR(rollout.greatest_curvature(), std::abs(curvature(robot, GetParam(), phi)), 1e-12);
    rollout.advance(1.0);
    const Pose end = advance(robot, start, GetParam(), phi, v * to.t);
    EXPECT_NEAR(rollout.x(), end.x, kAccuracy);
    EXPECT_NEAR(rollout.y(), end.y, kAccuracy);
    EXPECT_NEAR(rollout.theta(), end.theta, kAccuracy);
  });
}

TEST_P(ModesOfTheReferee, HaveTheWheelsOfTheVehicle)
{
  for_steering_angles([&](double phi) {
    const WheelAngles angles = wheel_angles(robot, GetParam(), phi);
    double fastest = 0.0;
    for (int i = 0; i < kWheels; ++i)
    {
      const referee::WheelMotion wheel(robot, GetParam(), i);
      EXPECT_NEAR(std::remainder(wheel.angle(phi) - angles[static_cast<std::size_t>(i)], M_PI), 0.0, 1e-9) << i;
      fastest = std::max(fastest, std::abs(wheel.speed_factor(phi)));
    }
    EXPECT_NEAR(fastest, wheel_speed_ratio(robot, GetParam(), phi), 1e-9);
  });
}

TEST_P(ModesOfTheReferee, HaveTheLimitOfPhiOfTheVehicle)
{
  const double limit = max_phi(robot, GetParam());
  for (double sign : {1.0, -1.0})
  {
    expect_accepted(judge(Script({}, GetParam(), sign * limit)));
    expect_refused(judge(Script({}, GetParam(), sign * (limit + 1e-5))), "steering angle");
  }
}

TEST(WheelsOfTheReferee, HaveZerosForModesThatAreNotPlanned)
{
  const referee::Wheels wheels{Robot()};
  for (int number = 0; number < 256; ++number)
  {
    const Mode mode = static_cast<Mode>(number);
    if (is_planned(mode)) continue;
    EXPECT_EQ(wheels.greatest_speed_factor(mode), 0.0) << number;
    EXPECT_EQ(wheels.greatest_gain(mode), 0.0) << number;
    EXPECT_EQ(wheels.motion(mode, kWheels - 1).angle(0.3), 0.0) << number;
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, ModesOfTheReferee, testing::ValuesIn(kPlannedModes),
                         [](const auto& mode) { return to_string(mode.param); });

}  // namespace
}  // namespace fourwis
