#include "track/creep.h"

#include <gtest/gtest.h>

#include "../support/random.h"
#include "track/roll_out.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 47;

/// Checks that the motion starts and ends at rest, agrees with the roll-out, and keeps the speed. Returns its end.
Pose follow(const Robot& robot, const Creep& creep, double speed)
{
  EXPECT_EQ(creep.front().v, 0.0);
  EXPECT_EQ(creep.back().v, 0.0);
  for (std::size_t k = 0; k + 1 < creep.size(); ++k)
  {
    const TrajectoryPoint &from = creep[k], &to = creep[k + 1];
    EXPECT_GT(to.t, from.t);
    EXPECT_LE(std::abs(to.v), speed + 1e-12);
    const double h = to.t - from.t;
    const MotionState end = roll_out(robot, from.mode, {from.pose(), from.v, from.phi}, {(to.v - from.v) / h, 0.0}, h);
    EXPECT_LT(distance(end.pose, to.pose()), 1e-9);
    EXPECT_NEAR(end.pose.theta, to.theta, 1e-9);
  }
  return creep.back().pose();
}

TEST(Creep, TurnsInPlace)
{
  const Robot robot;
  Random random(kSeed);
  for (int trial = 0; trial < 100; ++trial)
  {
    const Pose from = random.pose(5.0);
    const double angle = random.between(-0.5, 0.5);
    const Pose end = follow(robot, creeping_turn(robot, from, angle, 0.1), 0.1);
    EXPECT_LT(distance(end, from), 1e-12);
    EXPECT_NEAR(end.theta, from.theta + angle, 1e-9);
  }
}

TEST(Creep, ShiftsWithoutTurning)
{
  const Robot robot;
  Random random(kSeed);
  for (int trial = 0; trial < 100; ++trial)
  {
    const Pose from = random.pose(5.0);
    const double size = std::pow(10.0, random.between(-3.0, 0.0));
    const Pose to = {from.x + random.between(-size, size), from.y + random.between(-size, size), random.angle()};
    const Creep creep = creeping_shift(from, to, 0.1);
    const Pose end = follow(robot, creep, 0.1);
    EXPECT_LT(distance(end, to), 1e-9);
    EXPECT_NEAR(end.theta, from.theta, 1e-12);
    EXPECT_LE(std::abs(creep.front().phi), M_PI_2 + 1e-9);
  }
}

TEST(Creep, NoDistanceIsNoHarm)
{
  const Robot robot;
  EXPECT_EQ(follow(robot, creeping_turn(robot, {}, 0.0, 0.1), 0.1).theta, 0.0);
  EXPECT_EQ(follow(robot, creeping_shift({}, {}, 0.1), 0.1).x, 0.0);
}

}  // namespace
}  // namespace fourwis
