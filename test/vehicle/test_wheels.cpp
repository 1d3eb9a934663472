#include "fourwis_navigation/vehicle/wheels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/random.h"
#include "fourwis_navigation/vehicle/kinematics.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 3;
constexpr double kDegree = M_PI / 180.0;

double gap_modulo_pi(double a, double b)
{
  return std::abs(std::remainder(a - b, M_PI));
}

/// A row of the wheel table of the CAN bridge's reference: angles [deg] and speeds for each m/s of C, the centre of the
/// wheels.
struct Row
{
  Mode mode;
  double phi;
  std::array<double, kWheels> angles, speeds;
};

constexpr Row kTable[] = {{Mode::ackermann, 30.0, {46.0, 21.8, -46.0, -21.8}, {0.803, 1.553, 0.803, 1.553}},
                          {Mode::lateral, 30.0, {108.2, 71.8, 157.0, 23.0}, {1.848, 1.848, 0.627, 0.627}},
                          {Mode::lateral, -30.0, {23.0, 157.0, 71.8, 108.2}, {0.627, 0.627, 1.848, 1.848}},
                          {Mode::parallel, 37.0, {37.0, 37.0, 37.0, 37.0}, {1.0, 1.0, 1.0, 1.0}},
                          {Mode::ackermann, 0.0, {0.0, 0.0, 0.0, 0.0}, {1.0, 1.0, 1.0, 1.0}},
                          {Mode::lateral, 0.0, {90.0, 90.0, 90.0, 90.0}, {1.0, 1.0, 1.0, 1.0}}};

TEST(WheelAngles, AreThoseOfTheWheelTable)
{
  for (const Row& row : kTable)
  {
    const WheelAngles angles = wheel_angles({}, row.mode, row.phi * kDegree);
    for (std::size_t i = 0; i < kWheels; ++i)
      EXPECT_LE(gap_modulo_pi(angles[i], row.angles[i] * kDegree), 0.06 * kDegree)
          << to_string(row.mode) << " " << row.phi << " deg, wheel " << i << ": " << angles[i] / kDegree << " deg";
  }
}

TEST(WheelSpeedRatio, IsThatOfTheFastestWheelOfTheTable)
{
  for (const Row& row : kTable)
    EXPECT_NEAR(wheel_speed_ratio({}, row.mode, row.phi * kDegree),
                *std::max_element(row.speeds.begin(), row.speeds.end()), 6e-4)
        << to_string(row.mode) << " " << row.phi << " deg";
}

/// The motion of each steering axis in the frame of the body per metre of C, by differences along the arc.
std::array<Pose, kWheels> axis_velocities(const Robot& robot, Mode mode, double phi)
{
  constexpr double h = 1e-5;
  const Pose ahead = advance(robot, {}, mode, phi, h), behind = advance(robot, {}, mode, phi, -h);
  std::array<Pose, kWheels> velocities;
  for (std::size_t i = 0; i < kWheels; ++i)
  {
    const WheelPosition axis = wheel_positions(robot)[i];
    const Pose to = compose(ahead, {axis.x, axis.y, 0.0}), from = compose(behind, {axis.x, axis.y, 0.0});
    velocities[i] = {(to.x - from.x) / (2.0 * h), (to.y - from.y) / (2.0 * h), 0.0};
  }
  return velocities;
}

TEST(WheelAngles, PointWhereTheSteeringAxesMove)
{
  Random random(kSeed);
  const Robot robot;
  for (int k = 0; k < 300; ++k)
  {
    const Mode mode = random.mode();
    const double phi = random.steering(robot, mode);
    const auto velocities = axis_velocities(robot, mode, phi);
    const WheelAngles angles = wheel_angles(robot, mode, phi);
    double fastest = 0.0;
    for (std::size_t i = 0; i < kWheels; ++i)
    {
      ASSERT_LE(heading_gap(angles[i], std::atan2(velocities[i].y, velocities[i].x)), 1e-6) << to_string(mode) << phi;
      ASSERT_GT(angles[i], -M_PI);
      ASSERT_LE(angles[i], M_PI);
      fastest = std::max(fastest, std::hypot(velocities[i].x, velocities[i].y));
    }
    ASSERT_NEAR(wheel_speed_ratio(robot, mode, phi), fastest, 1e-6) << to_string(mode) << phi;
  }
}

struct ReorientationTime : testing::Test
{
  WheelAngles any() { return {random.angle(), random.angle(), random.angle(), random.angle()}; }
  double time(const WheelAngles& from, const WheelAngles& to) const { return reorientation_time(robot, from, to); }

  testing::ScopedTrace trace{__FILE__, __LINE__, "seed " + std::to_string(kSeed)};
  Random random{kSeed};
  Robot robot;
};

TEST_F(ReorientationTime, IsZeroToTheSameAngles)
{
  for (int k = 0; k < 100; ++k)
  {
    const WheelAngles angles = any();
    ASSERT_EQ(time(angles, angles), 0.0);
  }
}

TEST_F(ReorientationTime, IsZeroToTheOppositeAngles)
{
  for (int k = 0; k < 100; ++k)
  {
    const WheelAngles angles = any();
    WheelAngles opposite = angles;
    for (double& angle : opposite) angle += random.chance(0.5) ? M_PI : -M_PI;
    ASSERT_NEAR(time(angles, opposite), 0.0, 1e-12);
  }
}

TEST_F(ReorientationTime, IsTheSameBothWaysAndNeverThatOfMoreThanAQuarterTurn)
{
  for (int k = 0; k < 1000; ++k)
  {
    const WheelAngles a = any(), b = any();
    ASSERT_NEAR(time(a, b), time(b, a), 1e-12);
    ASSERT_LE(time(a, b), M_PI_2 / robot.wheel_max_rate);
  }
}

TEST_F(ReorientationTime, IsNeverLongerThanByADetour)
{
  for (int k = 0; k < 1000; ++k)
  {
    const WheelAngles a = any(), b = any(), c = any();
    ASSERT_LE(time(a, c), time(a, b) + time(b, c) + 1e-12);
  }
}

TEST_F(ReorientationTime, IsThatOfTheSlowestWheel)
{
  EXPECT_NEAR(time({0.0, 0.0, 0.0, 0.0}, {0.1, -0.4, 0.2, M_PI - 0.3}), 0.4 / robot.wheel_max_rate, 1e-12);
}

TEST_F(ReorientationTime, FromStraightAheadToStraightSidewaysIsHalfASecond)
{
  EXPECT_NEAR(time(wheel_angles(robot, Mode::ackermann, 0.0), wheel_angles(robot, Mode::lateral, 0.0)), 0.5, 1e-9);
}

TEST_F(ReorientationTime, IsThatOfAWayWithinTheWheelsTravel)
{
  robot.wheel_max_angle = 100.0 * kDegree;
  const auto seconds = [&](double from, double to) {
    return time({from * kDegree, 0.0, 0.0, 0.0}, {to * kDegree, 0.0, 0.0, 0.0}) * robot.wheel_max_rate / kDegree;
  };
  EXPECT_NEAR(seconds(70.0, 120.0), 130.0, 1e-9) << "120 deg is out of reach, so -60 deg";
  EXPECT_NEAR(seconds(70.0, -60.0), 130.0, 1e-9);
  EXPECT_NEAR(seconds(85.0, 95.0), 10.0, 1e-9) << "both within reach";
  EXPECT_NEAR(seconds(-85.0, 85.0), 10.0, 1e-9) << "85 deg is -95 deg";
  EXPECT_NEAR(seconds(0.0, 180.0), 0.0, 1e-9);
}

TEST_F(ReorientationTime, IsNoLessWithLessTravel)
{
  for (int k = 0; k < 1000; ++k)
  {
    const WheelAngles a = any(), b = any();
    robot.wheel_max_angle = 2.0 * M_PI;
    const double free = time(a, b);
    robot.wheel_max_angle = random.between(M_PI_2, M_PI);
    ASSERT_GE(time(a, b), free - 1e-12);
    ASSERT_LE(time(a, b), M_PI / robot.wheel_max_rate);
  }
}

TEST_F(ReorientationTime, FallsWithTheWheelsRate)
{
  Robot slow;
  slow.wheel_max_rate = robot.wheel_max_rate / 4.0;
  for (int k = 0; k < 100; ++k)
  {
    const WheelAngles a = any(), b = any();
    ASSERT_NEAR(reorientation_time(slow, a, b), 4.0 * time(a, b), 1e-12);
  }
}

}  // namespace
}  // namespace fourwis
