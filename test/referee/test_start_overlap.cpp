// A body that overlaps at the start: how deep it may be, and that it may only come out.

#include <gtest/gtest.h>

#include <cmath>

#include "../support/driven_poses.h"
#include "../support/grids.h"
#include "../support/rectangle.h"
#include "referee_script.h"

namespace fourwis
{
namespace
{

/// A hall whose lower wall is a metre thick.
struct StartOverlap : testing::Test
{
  StartOverlap() { occupy_block(grid, 0, 0, 160, 20); }

  /// With its right side so deep in the wall.
  Pose in_wall(double depth) const { return {2.0, 1.0 + robot.width / 2.0 - depth, 0.0}; }

  Verdict judge(const Script& script) const
  {
    return Referee(grid, {}, robot, options).judge(script.start(), script.end(), script.points());
  }
  bool accepts(const Script& script) const { return judge(script).accepted(); }

  const Robot robot;
  OccupancyGrid grid = free_area(8.0, 6.0, 0.05);
  RefereeOptions options;
};

TEST_F(StartOverlap, UpToTheToleranceMayBeLeft)
{
  for (double depth : {0.001, 0.02, 0.0299})
  {
    const Script away = Script(in_wall(depth), Mode::lateral).drive(0.5, 1.0);
    EXPECT_TRUE(accepts(away)) << depth << "\n" << sentences(judge(away));
    EXPECT_EQ(judge(away).min_clearance, 0.0);
  }
  EXPECT_FALSE(accepts(Script(in_wall(0.0301), Mode::lateral).drive(0.5, 1.0)));
}

TEST_F(StartOverlap, HasTheToleranceOfTheOptions)
{
  options.start_tolerance = 0.1;
  EXPECT_TRUE(accepts(Script(in_wall(0.099), Mode::lateral).drive(0.5, 1.0)));
  EXPECT_FALSE(accepts(Script(in_wall(0.101), Mode::lateral).drive(0.5, 1.0)));
  options.start_tolerance = 0.0;
  EXPECT_TRUE(accepts(Script(in_wall(0.0), Mode::lateral).drive(0.5, 1.0)));
  EXPECT_FALSE(accepts(Script(in_wall(0.001), Mode::lateral).drive(0.5, 1.0)));
}

TEST_F(StartOverlap, MayStayAsDeepAsItIs)
{
  EXPECT_TRUE(accepts(Script(in_wall(0.02), Mode::ackermann).drive(0.5, 1.0)));
  EXPECT_TRUE(accepts(Script(in_wall(0.02), Mode::ackermann)));
}

TEST_F(StartOverlap, MayNeverGrowNotByMicrometres)
{
  for (double deeper : {-0.001, -0.05, -1e-5})
  {
    const double phi = std::asin(deeper / 1.0);
    const Script script = Script(in_wall(0.015), Mode::parallel, phi).drive(0.5, 2.0);
    const Verdict verdict = judge(script);
    EXPECT_TRUE(complains_of(verdict, "collision")) << deeper << "\n" << sentences(verdict);
  }
}

/// Out by a part, and in again to less than at the start: deeper than before all the same.
TEST_F(StartOverlap, MayNotGrowAgainAfterItHasShrunk)
{
  const Script out = Script(in_wall(0.02), Mode::parallel, 0.01).drive(0.5, 1.0);
  EXPECT_TRUE(accepts(out));
  Script and_in = out;
  and_in.drive(-0.5, 0.3);
  EXPECT_TRUE(complains_of(judge(and_in), "collision"));
}

TEST_F(StartOverlap, MayNotComeBackOnceTheBodyHasBeenFree)
{
  Script script = Script(in_wall(0.02), Mode::lateral).drive(0.5, 0.5);
  EXPECT_TRUE(accepts(script));
  EXPECT_GT(script.end().y, in_wall(0.0).y);
  script.drive(-0.5, 0.48);
  ASSERT_GT(script.end().y, in_wall(0.02).y);
  ASSERT_LT(script.end().y, in_wall(0.0).y);
  EXPECT_TRUE(complains_of(judge(script), "collision"));
}

TEST_F(StartOverlap, IsNoLeaveToTouchAnythingElse)
{
  // The body leaves the wall on a bend, along a post that its front left corner grazes by a millimetre on the way.
  const Script away = Script(in_wall(0.01), Mode::lateral).drive(0.5, 2.0);
  EXPECT_TRUE(accepts(away));
  occupy_block(grid, 49, 40, 1, 1);
  EXPECT_TRUE(complains_of(judge(away), "column 49, row 40"));
}

TEST_F(StartOverlap, BeyondTheEdgeOfTheGridIsNoOverlap)
{
  const Pose off{robot.length / 2.0 - 0.001, 3.0, 0.0};
  EXPECT_TRUE(complains_of(judge(Script(off, Mode::ackermann).drive(0.5, 1.0)), "leaves the grid"));
}

TEST_F(StartOverlap, IsNotToleratedOnTheWay)
{
  const Script script = Script(in_wall(0.02), Mode::lateral).drive(0.5, 1.0);
  const Referee referee(grid, {}, robot, options);
  EXPECT_TRUE(referee.first_violation_from(0.0, script.points()).has_value());
  EXPECT_FALSE(referee.first_violation_from(0.5, script.points()).has_value());
}

/// Depths of random drives out of clutter, held against the exact rectangle's.
TEST_F(StartOverlap, IsJudgedAsTheDepthOfTheExactRectangleSays)
{
  constexpr unsigned kSeed = 61;
  int accepted = 0, refused = 0;
  for (int k = 0; k < 6000; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", drive " + std::to_string(k));
    Random random(kSeed + static_cast<unsigned>(k));
    const OccupancyGrid place = clutter(random, 4.0, 0.05, 4, random.pose(5.0));
    const ExactRectangle body(place, robot);
    Pose start = compose(place.origin, {random.between(0.6, 3.4), random.between(0.6, 3.4), random.angle()});
    if (const double depth = body.depth(start); depth < 0.001 || depth > 0.029) continue;
    const Mode mode = random.mode();
    const Script script = Script(start, mode, random.steering(robot, mode)).drive(random.chance(0.5) ? 0.3 : -0.3, 0.3);
    // Dense samples of the drive; those of no clear verdict are left out.
    double least = body.depth(start), most_growth = 0.0;
    bool was_free = false, back = false;
    for (const Pose& pose : driven_poses({}, script.points()))
    {
      const double depth = body.depth(pose);
      back |= was_free && depth > 1e-4;
      was_free |= depth <= 0.0;
      most_growth = std::max(most_growth, depth - least);
      least = std::min(least, depth);
    }
    if (!back && most_growth > 1e-9 && most_growth < 1e-4) continue;
    const bool fine = !back && most_growth <= 1e-9;
    const Verdict verdict = Referee(place, {}, robot, options).judge(script.start(), script.end(), script.points());
    ASSERT_EQ(!complains_of(verdict, "collision"), fine) << "grows by " << most_growth << "\n" << sentences(verdict);
    ++(fine ? accepted : refused);
  }
  EXPECT_GE(accepted, 60);
  EXPECT_GE(refused, 60);
}

}  // namespace
}  // namespace fourwis
