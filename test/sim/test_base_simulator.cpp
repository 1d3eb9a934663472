#include "fourwis_navigation/sim/base_simulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "../drives/simulated_drive.h"
#include "../support/random.h"
#include "../support/sentences.h"
#include "fourwis_navigation/vehicle/wheel_odometry.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 54;
constexpr Mode kDrivenModes[] = {Mode::ackermann, Mode::lateral, Mode::parallel, Mode::spin};

double fastest(const WheelMotion& wheels)
{
  return greatest_magnitude(wheels.speed);
}

/// Actuators without lag and perfect encoders.
SimulatorOptions ideal()
{
  SimulatorOptions options;
  options.command_latency = 0.0;
  options.actuators = {0.0, 0.0, 1000.0};
  options.encoders = {0.0, 0.0, 0.0, 0.0};
  return options;
}

SimulatorOptions realistic()
{
  SimulatorOptions options;
  options.command_latency = 0.06;
  options.slip = {0.03, 0.005};
  options.encoders.angle_noise = 0.001;
  options.encoders.speed_noise = 0.001;
  return options;
}

TEST(BaseSimulator, DrivesEveryModeAsItsKinematicsSay)
{
  for (Mode mode : kDrivenModes)
    for (double v : {0.5, -0.5})
    {
      SimulatedDrive robot({}, ideal());
      const double phi = mode == Mode::spin ? 0.0 : 0.3;
      const Pose start{2.0, 1.0, 0.4};
      robot.base.place(start);
      ASSERT_TRUE(robot.align(mode, phi));
      robot.drive(mode, v, phi, 2.0);
      const Pose expected = move(start, body_twist(robot.robot, mode, v, phi), 2.0);
      EXPECT_LT(distance(robot.base.pose(), expected), 1e-3) << to_string(mode) << " " << v;
      EXPECT_NEAR(robot.base.pose().theta, expected.theta, 1e-3);
    }
}

/// Drives at random, with faults. Returns the motion and the state of the base in each period.
std::vector<double> random_drive(unsigned commands, int seed, int parts)
{
  SimulatorOptions options = realistic();
  options.seed = seed;
  SimulatedDrive robot({}, options);
  Random random(commands);
  std::vector<double> record;
  for (int k = 0; k < 400; ++k)
  {
    if (k % 80 == 79) robot.base.inject({WheelFault::Kind::dead_drive, random.whole(0, 3)});
    const Mode mode = k % 50 == 0 ? random.mode() : robot.base.wheels().mode;
    if (!random.chance(0.1))
      robot.base.command({mode, ++robot.sequence, robot.wheels_for(mode, random.between(0.0, 1.0), 0.2)});
    for (int part = 0; part < parts; ++part) robot.base.step(SimulatedDrive::kPeriod / parts);
    const WheelState state = robot.base.wheels();
    record.insert(record.end(), {robot.base.pose().x, robot.base.pose().y, robot.base.pose().theta, state.stamp});
    record.insert(record.end(), state.motion.angle.begin(), state.motion.angle.end());
    record.insert(record.end(), state.motion.speed.begin(), state.motion.speed.end());
  }
  return record;
}

TEST(BaseSimulator, RepeatsItselfBitForBit)
{
  const std::vector<double> record = random_drive(kSeed, 5, 1);
  EXPECT_EQ(record, random_drive(kSeed, 5, 1));
  EXPECT_EQ(record, random_drive(kSeed, 5, 4)) << "time in other steps";
  EXPECT_NE(record, random_drive(kSeed, 6, 1)) << "another seed";
}

TEST(BaseSimulator, ObeysALatencyLater)
{
  SimulatorOptions options = ideal();
  options.command_latency = 0.06;
  SimulatedDrive robot({}, options);
  robot.base.command({Mode::ackermann, 17, robot.wheels_for(Mode::ackermann, 0.0, 0.0)});
  robot.base.step(0.06);
  EXPECT_EQ(robot.base.wheels().sequence, 0u);
  robot.base.step(0.001);
  EXPECT_EQ(robot.base.wheels().sequence, 17u);
  EXPECT_EQ(robot.base.wheels().mode, Mode::ackermann);
}

TEST(BaseSimulator, ComesToRestBeforeItTurnsItsWheelsForAnotherMode)
{
  SimulatedDrive robot({}, realistic());
  ASSERT_TRUE(robot.align(Mode::ackermann, 0.0));
  robot.drive(Mode::ackermann, 0.8, 0.0, 1.0);
  const WheelMotion wanted = robot.wheels_for(Mode::lateral, 0.5, 0.2);
  const PerWheel before = robot.base.truth().angle;
  bool has_turned = false, has_driven = false;
  for (int k = 0; k < 200; ++k)
  {
    robot.command(Mode::lateral, wanted, SimulatedDrive::kPeriod);
    const WheelMotion truth = robot.base.truth();
    const double turned = std::abs(truth.angle[0] - before[0]), left = std::abs(truth.angle[0] - wanted.angle[0]);
    has_turned |= turned > 0.01;
    has_driven |= has_turned && fastest(truth) > 0.1;
    if (turned <= 0.01 || left <= 0.06) continue;
    ASSERT_LT(fastest(truth), 0.005) << "it turns and drives at once";
  }
  EXPECT_TRUE(has_turned);
  EXPECT_TRUE(has_driven);
}

/// Standstill is measured; the targets of the drives do not count.
TEST(BaseSimulator, DoesNotTurnWheelsThatRollOnAfterTheyAreToldToStand)
{
  SimulatorOptions options = ideal();
  options.stop_deceleration = 10.0;
  options.actuators.drive_acceleration = 1.0;
  SimulatedDrive robot({}, options);
  ASSERT_TRUE(robot.align(Mode::ackermann, 0.0));
  robot.drive(Mode::ackermann, 0.8, 0.0, 2.0);
  const WheelMotion wanted = robot.wheels_for(Mode::lateral, 0.0, 0.0);
  bool has_turned = false;
  for (int k = 0; k < 100; ++k)
  {
    robot.command(Mode::lateral, wanted, SimulatedDrive::kPeriod);
    has_turned |= std::abs(robot.base.truth().angle[0]) > 0.01;
    ASSERT_TRUE(!has_turned || fastest(robot.base.truth()) < 0.005);
  }
  EXPECT_TRUE(has_turned);
}

TEST(BaseSimulator, StopsOnItsArcAndHoldsTheAngles)
{
  SimulatedDrive robot({}, ideal());
  ASSERT_TRUE(robot.align(Mode::ackermann, 0.3));
  robot.drive(Mode::ackermann, 0.8, 0.3, 1.0);
  const Pose before = robot.base.pose();
  const PerWheel angles = robot.base.truth().angle;
  robot.command(Mode::none, {{1.0, 1.0, 1.0, 1.0}, {2.0, 2.0, 2.0, 2.0}}, 1.0);
  EXPECT_EQ(fastest(robot.base.truth()), 0.0);
  EXPECT_EQ(robot.base.truth().angle, angles);
  const double ratio = fastest(wheel_motion(robot.robot, Mode::ackermann, 1.0, 0.3));
  const double way = 0.8 * 0.8 * ratio / (2.0 * SimulatorOptions{}.stop_deceleration);  // the fastest wheel's limit
  const Pose expected = move(before, body_twist(robot.robot, Mode::ackermann, way, 0.3), 1.0);
  EXPECT_LT(distance(robot.base.pose(), expected), 0.003);
  EXPECT_NEAR(robot.base.pose().theta, expected.theta, 0.003);
}

TEST(BaseSimulator, StopsWithoutCommandsAndWaitsForANewCommandAtRest)
{
  SimulatedDrive robot({}, ideal());
  ASSERT_TRUE(robot.align(Mode::parallel, 0.2));
  robot.drive(Mode::parallel, 0.9, 0.2, 1.0);
  const WheelMotion wanted = robot.wheels_for(Mode::parallel, 0.9, 0.2);
  robot.base.step(0.129);
  EXPECT_EQ(robot.base.wheels().state, BaseState::enabled);
  EXPECT_NEAR(fastest(robot.base.truth()), 0.9, 1e-9);
  robot.base.step(0.05);
  EXPECT_EQ(robot.base.wheels().state, BaseState::stopping);
  robot.command(Mode::parallel, wanted, 0.2);
  EXPECT_LT(fastest(robot.base.truth()), 0.5) << "a stop cannot be interrupted";
  robot.base.step(1.0);
  EXPECT_EQ(robot.base.wheels().state, BaseState::enabled);
  EXPECT_EQ(fastest(robot.base.truth()), 0.0);
  EXPECT_EQ(robot.base.truth().angle, wanted.angle);
  robot.command(Mode::parallel, wanted, 1.0);
  EXPECT_NEAR(fastest(robot.base.truth()), 0.9, 1e-9);
}

TEST(BaseSimulator, RefusesWhatIsNoCommand)
{
  BaseSimulator base({}, {});
  for (double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
  {
    EXPECT_FALSE(base.command({Mode::ackermann, 1, {{0.0, bad, 0.0, 0.0}, {}}}));
    EXPECT_FALSE(base.command({Mode::ackermann, 1, {{}, {0.0, 0.0, 0.0, bad}}}));
  }
  EXPECT_FALSE(base.command({static_cast<Mode>(9), 1, {}}));
  base.step(0.1);
  EXPECT_EQ(base.wheels().sequence, 0u);
}

TEST(BaseSimulator, SlowsAllWheelsDownTogether)
{
  SimulatedDrive robot({}, ideal());
  ASSERT_TRUE(robot.align(Mode::lateral, 0.5));
  const Pose before = robot.base.pose();
  robot.drive(Mode::lateral, 3.0, 0.5, 1.0);
  EXPECT_NEAR(fastest(robot.base.truth()), robot.robot.wheel_max_speed, 1e-9);
  const ModeMotion motion = mode_motion(robot.robot, Mode::lateral, robot.base.truth());
  EXPECT_NEAR(motion.phi, 0.5, 1e-9);
  EXPECT_NEAR(std::hypot(robot.base.twist().vx, robot.base.twist().vy), motion.v, 1e-9);
  EXPECT_GT(distance(robot.base.pose(), before), 0.5);
}

TEST(BaseSimulator, NeverTurnsAWheelBeyondItsTravelNorFasterThanItCan)
{
  SimulatedDrive robot({}, ideal());
  Random random(kSeed);
  PerWheel before = robot.base.truth().angle;
  for (int k = 0; k < 500; ++k)
  {
    if (k % 50 == 0) robot.base.step(1.0);
    before = robot.base.truth().angle;
    WheelMotion wild;
    for (double& angle : wild.angle) angle = random.between(-10.0, 10.0);
    robot.command(Mode::parallel, wild, SimulatedDrive::kPeriod);
    for (std::size_t i = 0; i < kWheels; ++i)
    {
      const double angle = robot.base.truth().angle[i];
      ASSERT_LE(std::abs(angle), robot.robot.wheel_max_angle);
      ASSERT_LE(std::abs(angle - before[i]), robot.robot.wheel_max_rate * SimulatedDrive::kPeriod + 1e-9);
    }
  }
}

TEST(BaseSimulator, DoesNotDriveWithAStuckWheelAndNeedsToBeCleared)
{
  SimulatedDrive robot({}, {});
  robot.base.inject({WheelFault::Kind::stuck_steering, 1});
  EXPECT_FALSE(robot.align(Mode::lateral, 0.0));
  robot.drive(Mode::lateral, 0.5, 0.0, 5.0);
  EXPECT_EQ(robot.base.wheels().state, BaseState::fault);
  EXPECT_EQ(robot.base.truth().angle[1], 0.0);
  EXPECT_EQ(fastest(robot.base.truth()), 0.0);
  robot.base.clear_faults();
  robot.base.step(0.3);
  EXPECT_EQ(robot.base.wheels().state, BaseState::enabled);
  EXPECT_TRUE(robot.align(Mode::lateral, 0.0));
}

TEST(BaseSimulator, RollsAlongOnADeadDrive)
{
  SimulatedDrive robot({}, ideal());
  ASSERT_TRUE(robot.align(Mode::ackermann, 0.2));
  robot.base.inject({WheelFault::Kind::dead_drive, 3});
  robot.drive(Mode::ackermann, 0.5, 0.2, 1.0);
  const WheelMotion expected = wheel_motion(robot.robot, Mode::ackermann, 0.5, 0.2);
  EXPECT_NEAR(robot.base.twist().vx, 0.5, 1e-6);
  EXPECT_NEAR(robot.base.wheels().motion.speed[3], expected.speed[3], 1e-6);
}

TEST(BaseSimulator, KeepsTheReadingsOfFrozenEncoders)
{
  SimulatedDrive robot({}, ideal());
  ASSERT_TRUE(robot.align(Mode::ackermann, 0.2));
  robot.base.inject({WheelFault::Kind::frozen_encoders, 0});
  robot.drive(Mode::ackermann, 0.5, 0.2, 1.0);
  EXPECT_EQ(robot.base.wheels().motion.speed[0], 0.0);
  EXPECT_GT(robot.base.truth().speed[0], 0.4);
  EXPECT_THROW(robot.base.inject({WheelFault::Kind::frozen_encoders, 4}), std::out_of_range);
}

TEST(BaseSimulator, IsFollowedByTheOdometryOfItsWheels)
{
  SimulatedDrive robot({}, {});
  WheelOdometry odometry(robot.robot, {});
  double length = 0.0;
  for (const auto& [mode, v, phi] : {std::tuple{Mode::ackermann, 0.8, 0.4},
                                     {Mode::lateral, -0.6, 0.3},
                                     {Mode::parallel, 0.7, -0.8},
                                     {Mode::spin, 0.5, 0.0}})
  {
    ASSERT_TRUE(robot.align(mode, phi));
    odometry.update(robot.base.time(), robot.base.wheels().motion);
    for (int k = 0; k < 300; ++k)
    {
      if (k % 2 == 0) robot.base.command({mode, ++robot.sequence, robot.wheels_for(mode, k < 200 ? v : 0.0, phi)});
      robot.base.step(0.01);
      odometry.update(robot.base.time(), robot.base.wheels().motion);
    }
    length += 2.0 * std::abs(v);
  }
  EXPECT_LT(distance(odometry.state().pose, robot.base.pose()), 0.002 * length);
  EXPECT_NEAR(odometry.state().pose.theta, robot.base.pose().theta, 0.002 * length);
}

TEST(BaseSimulator, RejectsWheelsThatCannotAlignInTime)
{
  Robot slow;
  slow.wheel_max_rate = 0.4;
  const std::string text = error_of<std::invalid_argument>([&] { BaseSimulator(slow, {}); });
  EXPECT_TRUE(says(text, "'alignment_timeout' is 3, expected at least 9.06 s"));
  EXPECT_TRUE(says(text, "'wheel_max_rate' is 0.4 rad/s"));
  SimulatorOptions patient;
  patient.interlock.alignment_timeout = 9.06;
  EXPECT_NO_THROW(BaseSimulator(slow, patient));
}

TEST(BaseSimulator, RejectsInvalidOptionsAndTimes)
{
  const Robot robot;
  EXPECT_THROW(BaseSimulator(robot, {}).step(-0.01), std::invalid_argument);
  EXPECT_THROW(BaseSimulator(robot, {}).step(NAN), std::invalid_argument);
  SimulatorOptions options;
  options.time_step = 0.0;
  EXPECT_THROW(BaseSimulator(robot, options), std::invalid_argument);
  options = {};
  options.command_latency = NAN;
  EXPECT_THROW(BaseSimulator(robot, options), std::invalid_argument);
  options = {};
  options.slip.drive_slip = 2.0;
  EXPECT_THROW(BaseSimulator(robot, options), std::invalid_argument);
  options = {};
  options.seed = -1;
  EXPECT_THROW(BaseSimulator(robot, options), std::invalid_argument);
  Robot wide = robot;
  wide.track_width = 0.7;
  EXPECT_THROW(BaseSimulator(wide, {}), std::invalid_argument);
}

}  // namespace
}  // namespace fourwis
