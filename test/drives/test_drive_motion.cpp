#include <gtest/gtest.h>

#include <cmath>

#include "drive_bench.h"

namespace fourwis::drives
{
namespace
{

constexpr int kTargetReached = 1 << 10, kInternalLimit = 1 << 11, kBit12 = 1 << 12, kBit13 = 1 << 13;

class DriveMotion : public ::testing::Test
{
protected:
  void SetUp() override { bench.boot(); }

  void enable(int mode)
  {
    ASSERT_EQ(bench.write(0x6060, 0, 1, mode), 0u);
    bench.enable();
  }
  int status() { return static_cast<int>(bench.read(0x6041)); }

  DriveBench bench;
};

TEST_F(DriveMotion, AVelocityLeftOverMovesTheMotorAsSoonAsItIsEnabled)
{
  bench.write(0x60FF, 0, 4, 5000);
  enable(9);
  bench.step();
  EXPECT_EQ(bench.motor.velocity, 5000);
}

TEST_F(DriveMotion, APositionLeftOverToo)
{
  bench.write(0x607A, 0, 4, 1000);
  enable(8);
  bench.pass(0.01);
  EXPECT_EQ(bench.motor.position, 1000);
}

TEST_F(DriveMotion, NothingMovesWithoutOperationEnabled)
{
  bench.write(0x6060, 0, 1, 9);
  bench.write(0x60FF, 0, 4, 5000);
  for (int word : {0x06, 0x07})
  {
    bench.control(word);
    bench.pass(0.1);
    EXPECT_EQ(bench.motor.velocity, 0);
    EXPECT_EQ(bench.drive.demand().kind, AxisDemand::Kind::off);
  }
}

TEST_F(DriveMotion, WithoutAModeItHoldsStill)
{
  bench.write(0x60FF, 0, 4, 5000);
  bench.write(0x607A, 0, 4, 5000);
  bench.enable();
  bench.pass(0.1);
  EXPECT_EQ(bench.motor.position, 0);
}

TEST_F(DriveMotion, CyclicPositionsAreReachedOneInterpolationPeriodLater)
{
  bench.write(0x60C2, 1, 1, 10);  // x 10^-3 s
  enable(8);
  for (int target : {1000, 2000, 3000})
  {
    bench.write(0x607A, 0, 4, target);
    bench.pass(0.005);
    EXPECT_NEAR(bench.motor.position, target - 500, 1e-6) << "half-way in a straight line";
    bench.pass(0.005);
    EXPECT_NEAR(bench.motor.position, target, 1e-6);
  }
  bench.step();
  EXPECT_NE(status() & kBit12, 0) << "follows";
  EXPECT_EQ(bench.read(0x6064), 3000u);
}

TEST_F(DriveMotion, VelocityIsMeasured)
{
  enable(9);
  bench.write(0x60FF, 0, 4, -12345);
  bench.pass(0.1);
  EXPECT_EQ(static_cast<std::int32_t>(bench.read(0x606C)), -12345);
  EXPECT_NEAR(static_cast<std::int32_t>(bench.read(0x6064)), -1234.5, 13);
}

TEST_F(DriveMotion, TheCounterWrapsAround)
{
  bench.motor.position = 2147483000.0;
  bench.step();
  enable(9);
  bench.write(0x60FF, 0, 4, 1000000);
  bench.pass(0.1);
  EXPECT_LT(static_cast<std::int32_t>(bench.read(0x6064)), -2147300000);
}

TEST_F(DriveMotion, ProfileVelocityRamps)
{
  bench.write(0x6083, 0, 4, 20000);
  bench.write(0x6084, 0, 4, 40000);
  bench.write(0x60FF, 0, 4, 4000);
  enable(3);
  bench.pass(0.1);
  EXPECT_NEAR(bench.motor.velocity, 2000, 1e-6);
  EXPECT_EQ(status() & kTargetReached, 0);
  bench.pass(0.15);
  EXPECT_NEAR(bench.motor.velocity, 4000, 1e-6);
  EXPECT_NE(status() & kTargetReached, 0);
  bench.write(0x60FF, 0, 4, 0);
  bench.pass(0.05);
  EXPECT_NEAR(bench.motor.velocity, 2000, 1e-6);
  bench.pass(0.1);
  EXPECT_NE(status() & kBit12, 0) << "stands";
}

TEST_F(DriveMotion, ProfilePositionIsATrapezoidToTheTarget)
{
  bench.write(0x6081, 0, 4, 10000);
  bench.write(0x6083, 0, 4, 50000);
  bench.write(0x6084, 0, 4, 50000);
  enable(1);
  for (const std::int64_t target : {5000, -3000, -2999, 0})
  {
    const double start = bench.motor.position, length = std::abs(static_cast<double>(target) - start);
    bench.write(0x607A, 0, 4, target);
    bench.control(0x3F);
    EXPECT_NE(status() & kBit12, 0) << "set-point acknowledged";
    bench.control(0x0F);
    EXPECT_EQ(status() & kBit12, 0);
    const double cruise = 10000.0 * 10000.0 / 50000.0;  // what speeding up and slowing down take together
    const double time = length > cruise ? length / 10000.0 + 0.2 : 2.0 * std::sqrt(length / 50000.0);
    double fastest = 0.0, passed = 0.0;
    while ((status() & kTargetReached) == 0 && passed < 5.0)
    {
      bench.step();
      passed += DriveBench::kStep;
      fastest = std::max(fastest, std::abs(bench.motor.velocity));
    }
    EXPECT_NEAR(passed, time, 0.006) << target;
    EXPECT_LE(fastest, 10000.0 + 1e-6);
    bench.step();
    EXPECT_NEAR(bench.motor.position, static_cast<double>(target), 1e-6);
  }
}

TEST_F(DriveMotion, ASetPointWaitsUnlessBitFiveIsSet)
{
  enable(1);
  bench.write(0x607A, 0, 4, 20000);
  bench.control(0x1F);
  bench.control(0x0F);
  bench.pass(0.02);
  bench.write(0x607A, 0, 4, 0);
  bench.control(0x1F);
  bench.control(0x0F);
  EXPECT_NE(status() & kBit12, 0) << "no room for a third";
  double furthest = 0.0;
  for (int k = 0; k < 3000; ++k)
  {
    bench.step();
    furthest = std::max(furthest, bench.motor.position);
  }
  EXPECT_NEAR(furthest, 20000.0, 1e-6);
  EXPECT_NEAR(bench.motor.position, 0.0, 1e-6);
  EXPECT_EQ(status() & kBit12, 0);
}

TEST_F(DriveMotion, RelativeSetPointsAdd)
{
  enable(1);
  bench.write(0x607A, 0, 4, 300);
  for (int k = 0; k < 3; ++k)
  {
    bench.control(0x5F);
    bench.control(0x0F);
    bench.pass(1.0);
  }
  EXPECT_NEAR(bench.motor.position, 900.0, 1e-6);
}

TEST_F(DriveMotion, SoftLimitsHoldItBack)
{
  bench.write(0x607D, 1, 4, -500);
  bench.write(0x607D, 2, 4, 800);
  for (int mode : {8, 1})
  {
    enable(mode);
    for (const std::int64_t target : {5000, -5000})
    {
      bench.write(0x607A, 0, 4, target);
      bench.control(0x3F);
      bench.control(0x0F);
      bench.pass(1.0);
      EXPECT_NEAR(bench.motor.position, target > 0 ? 800 : -500, 1e-6);
      EXPECT_NE(status() & kInternalLimit, 0);
    }
  }
}

TEST_F(DriveMotion, AVelocityBeyondItsOwnIsLimited)
{
  bench.motor_speed = 1e9;
  enable(9);
  bench.write(0x60FF, 0, 4, 2000000);
  bench.step();
  EXPECT_EQ(bench.motor.velocity, 1e6);
  EXPECT_NE(status() & kInternalLimit, 0);
}

TEST_F(DriveMotion, HaltBrakesAndGoesOn)
{
  bench.write(0x6084, 0, 4, 10000);
  bench.write(0x60FF, 0, 4, 1000);
  enable(9);
  bench.pass(0.1);
  bench.control(0x10F);
  bench.pass(0.05);
  EXPECT_NEAR(bench.motor.velocity, 500, 11);
  EXPECT_EQ(status() & kBit12, 0);
  bench.pass(0.06);
  EXPECT_EQ(bench.motor.velocity, 0);
  EXPECT_NE(status() & kTargetReached, 0);
  EXPECT_EQ(bench.state(), 0x27);
  bench.control(0x0F);
  bench.step();
  EXPECT_EQ(bench.motor.velocity, 1000);
}

TEST_F(DriveMotion, TheQuickStopEndsAs605ASays)
{
  const struct
  {
    int option;
    double deceleration;
    int moving, ended;
  } cases[] = {
      {0, 0, 0x40, 0x40}, {1, 1e4, 0x07, 0x40}, {2, 2e4, 0x07, 0x40}, {5, 1e4, 0x07, 0x07}, {6, 2e4, 0x07, 0x07}};
  for (const auto& row : cases)
  {
    SCOPED_TRACE(row.option);
    bench = DriveBench();
    SetUp();
    bench.write(0x605A, 0, 2, row.option);
    bench.write(0x6084, 0, 4, 10000);
    bench.write(0x6085, 0, 4, 20000);
    bench.write(0x60FF, 0, 4, 1000);
    enable(9);
    bench.pass(0.01);
    bench.control(0x02);
    bench.pass(0.02);
    EXPECT_EQ(bench.state(), row.moving);
    const double left = row.option > 0 ? 1000 - row.deceleration * 0.02 : 0.0;
    EXPECT_NEAR(bench.motor.velocity, left, 1e-3 * row.deceleration + 1);
    bench.pass(0.2);
    EXPECT_EQ(bench.state(), row.ended);
    EXPECT_EQ(bench.drive.demand().kind == AxisDemand::Kind::off, row.ended == 0x40);
    bench.control(0x0F);
    EXPECT_EQ(bench.state(), row.ended == 0x07 ? 0x27 : 0x40) << "transition 16 only where it holds";
  }
}

TEST_F(DriveMotion, AFaultBrakesFirst)
{
  bench.write(0x6085, 0, 4, 10000);
  bench.write(0x60FF, 0, 4, 1000);
  enable(9);
  bench.pass(0.01);
  bench.drive.fail(0x2310);
  EXPECT_EQ(bench.state(), 0x0F);
  bench.control(0x80);
  EXPECT_EQ(bench.state(), 0x0F) << "no reset before it stands";
  bench.pass(0.05);
  EXPECT_NEAR(bench.motor.velocity, 500, 11);
  bench.pass(0.06);
  EXPECT_EQ(bench.state(), 0x08);
  EXPECT_EQ(bench.drive.demand().kind, AxisDemand::Kind::off);
}

TEST_F(DriveMotion, AStuckAxisIsAFollowingError)
{
  bench.write(0x6065, 0, 4, 500);
  bench.write(0x6066, 0, 2, 100);
  bench.stuck = true;
  enable(8);
  bench.write(0x607A, 0, 4, 600);
  bench.sent.clear();
  bench.pass(0.1);
  EXPECT_EQ(bench.state(), 0x27);
  bench.pass(0.005);
  EXPECT_EQ(bench.state(), 0x08);
  EXPECT_NE(status() & kBit13, 0);
  EXPECT_TRUE(contains(bench.sent, raw(0x085, {0x11, 0x86, 0x21, 0, 0, 0, 0, 0})));
}

TEST_F(DriveMotion, HomingWhereItStandsCountsFromTheOffset)
{
  for (int method : {35, 37})
  {
    bench.motor.position = 12345;
    bench.step();
    bench.write(0x6098, 0, 1, method);
    bench.write(0x607C, 0, 4, -700);
    enable(6);
    EXPECT_EQ(status() & (kBit12 | kBit13), 0);
    bench.control(0x1F);
    EXPECT_EQ(status() & (kTargetReached | kBit12 | kBit13), kTargetReached | kBit12);
    bench.step();
    EXPECT_EQ(static_cast<std::int32_t>(bench.read(0x6064)), -700);
    EXPECT_EQ(bench.motor.position, 12345) << "nothing moves";
    bench.write(0x607A, 0, 4, -600);
    bench.write(0x6060, 0, 1, 8);
    bench.pass(0.01);
    EXPECT_EQ(bench.motor.position, 12445);
    bench = DriveBench();
    SetUp();
  }
}

TEST_F(DriveMotion, HomingWithoutAMethodIsAnError)
{
  enable(6);
  bench.control(0x1F);
  EXPECT_EQ(status() & (kBit12 | kBit13), kBit13);
}

TEST_F(DriveMotion, AJumpOfTheEncoderMovesTheMotorBack)
{
  enable(8);
  bench.pass(0.01);
  bench.drive.shift_encoder(250);
  bench.pass(0.01);
  EXPECT_EQ(bench.motor.position, -250);
  EXPECT_EQ(bench.read(0x6064), 0u);
}

TEST_F(DriveMotion, RebootWhileDrivingLosesPowerAndSettings)
{
  bench.write(0x60FF, 0, 4, 1000);
  enable(9);
  bench.sent.clear();
  bench.drive.reboot(bench.time());
  EXPECT_EQ(bench.drive.demand().kind, AxisDemand::Kind::off);
  bench.boot();
  EXPECT_EQ(bench.sent, Frames{raw(0x705, {0x00})});
  EXPECT_EQ(bench.state(), 0x40);
  EXPECT_EQ(bench.read(0x60FF), 0u);
}

}  // namespace
}  // namespace fourwis::drives
