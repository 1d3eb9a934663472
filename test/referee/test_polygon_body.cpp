// Bodies that are no rectangle around the wheels, against separating axes.

#include <gtest/gtest.h>

#include "../support/exact_polygon.h"
#include "../support/grids.h"
#include "referee_script.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 29;

/// The pose of C when base_link is at a pose.
Pose centre_at(const Robot& robot, const Pose& base_link)
{
  return compose(base_link, {robot.base_offset.x, robot.base_offset.y, 0.0});
}

Verdict stand(const Referee& referee, const Pose& pose)
{
  return referee.judge(pose, pose, Script(pose, Mode::ackermann).points());
}

TEST(PolygonBody, StandsWhereItOverlapsNothing)
{
  Random random(kSeed);
  int free = 0, colliding = 0;
  for (int k = 0; k < 60; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", map " + std::to_string(k));
    const OccupancyGrid grid = clutter(random, 6.0, k % 2 == 0 ? 0.05 : 0.13, 8, random.pose(20.0));
    Robot robot = polygon_robot(random);
    if (k % 4 == 3)
    {
      robot = Robot();
      robot.body_offset = {random.between(-0.15, 0.15), random.between(-0.04, 0.04)};
    }
    RefereeOptions options;
    options.start_tolerance = 0.0;
    const Referee referee(grid, {}, robot, options);
    const ExactPolygon body(grid, robot);
    for (int i = 0; i < 60; ++i)
    {
      const Pose base_link =
          compose(grid.origin, {random.between(-0.2, 6.2), random.between(-0.2, 6.2), random.angle()});
      const double overlap = body.overlap(base_link);
      if (overlap > 0.0 && overlap < 1e-7) continue;
      const Verdict verdict = stand(referee, centre_at(robot, base_link));
      ASSERT_EQ(verdict.accepted(), overlap == 0.0)
          << text(base_link) << " overlaps by " << overlap << sentences(verdict);
      (overlap == 0.0 ? free : colliding) += 1;
    }
  }
  EXPECT_GT(free, 500);
  EXPECT_GT(colliding, 500);
}

/// Clearance is how far it can be moved in any direction.
TEST(PolygonBody, KeepsItsClearanceWhereverItIsMovedToThatFar)
{
  Random random(kSeed);
  for (int k = 0; k < 40; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", map " + std::to_string(k));
    const OccupancyGrid grid = clutter(random, 6.0, 0.05, 6, random.pose(5.0));
    const Robot robot = polygon_robot(random);
    const Referee referee(grid, {}, robot);
    const ExactPolygon body(grid, robot);
    for (int i = 0; i < 10; ++i)
    {
      const Pose base_link = compose(grid.origin, {random.between(0.5, 5.5), random.between(0.5, 5.5), random.angle()});
      if (body.overlap(base_link) > 0.0) continue;
      const double clearance = stand(referee, centre_at(robot, base_link)).min_clearance;
      bool touches = false;
      for (int d = 0; d < 3600; ++d)
      {
        const double c = std::cos(d * M_PI / 1800.0), s = std::sin(d * M_PI / 1800.0);
        const auto moved = [&](double by) { return Pose{base_link.x + by * c, base_link.y + by * s, base_link.theta}; };
        ASSERT_FALSE(body.collides(moved(clearance - 1e-6))) << clearance;
        touches = touches || body.collides(moved(clearance + 1e-4 + 2e-3 * clearance));
      }
      ASSERT_TRUE(touches) << clearance;
    }
  }
}

/// With its nose to a wall it may turn on the spot only as far as the nose is round.
TEST(PolygonBody, MayLeaveAnOverlapAndGetNoDeeper)
{
  Robot robot;
  robot.footprint = {{0.7, 0.0}, {0.45, 0.31}, {-0.45, 0.31}, {-0.45, -0.31}, {0.45, -0.31}};
  OccupancyGrid grid = free_area(8.0, 6.0, 0.05);
  occupy_block(grid, 100, 0, 20, 120);  // from x = 5 m on
  const Referee referee(grid, {}, robot);
  const Pose in = {4.32, 3.02, 0.0};
  const Script away = Script(in, Mode::ackermann).drive(-1.0, 1.0),
               deeper = Script(in, Mode::ackermann).drive(0.02, 0.5);
  const auto accepts = [&](const Script& script) {
    return referee.judge(script.start(), script.end(), script.points()).accepted();
  };
  EXPECT_TRUE(accepts(away)) << sentences(referee.judge(away.start(), away.end(), away.points()));
  EXPECT_FALSE(accepts(deeper));
}

TEST(PolygonBody, CollisionsAreToldAsPlacesOfBaseLink)
{
  Robot robot;
  robot.base_offset = {0.34, 0.0};
  OccupancyGrid grid = free_area(8.0, 6.0, 0.05);
  occupy_block(grid, 60, 50, 4, 4);
  const Verdict verdict = stand(Referee(grid, {}, robot), centre_at(robot, {2.75, 2.5, 0.0}));
  ASSERT_FALSE(verdict.accepted());
  EXPECT_NE(sentences(verdict).find("the body at (2.75 m, 2.5 m"), std::string::npos) << sentences(verdict);
}

}  // namespace
}  // namespace fourwis
