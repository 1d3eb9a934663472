#include <gtest/gtest.h>

#include "../support/grids.h"
#include "../support/rectangle.h"
#include "fourwis_navigation/map/collision.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 6;
/// By how much the small discs stick out of the body's sides, most of all of it [m].
double overhang(const Robot& robot)
{
  const DiscCover cover = snug_cover(robot);
  return cover.radius + cover.centres.front().y - robot.width / 2.0;
}

Robot larger(Robot robot, double by)
{
  robot.length += 2.0 * by;
  robot.width += 2.0 * by;
  return robot;
}

/// Visits random poses in clutter, with a checker that keeps a margin where two discs do not fit.
template <typename Visit>
void for_poses(double margin, Visit visit)
{
  Random random(kSeed);
  for (double resolution : {0.02, 0.05, 0.1})
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", resolution " + std::to_string(resolution));
    Robot robot;
    robot.safety_margin = margin;
    const Site site(clutter(random, 6.0, resolution, 14, random.pose(10.0)), robot);
    const CollisionChecker snug(site.map, site.robot, std::vector<Pose>());
    for (int k = 0; k < 2000; ++k)
      visit(site, snug,
            compose(site.grid.origin, {random.between(0.0, 6.0), random.between(0.0, 6.0), random.angle()}));
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(SnugCover, SticksOutByCentimetres)
{
  EXPECT_LT(overhang(Robot()), 0.014);
}

struct SnugCollision : testing::TestWithParam<double>
{};

TEST_P(SnugCollision, LetsNoBodyTouchAnObstacle)
{
  int gained = 0;
  for_poses(GetParam(), [&](const Site& site, const CollisionChecker& snug, const Pose& pose) {
    if (!snug.is_free(pose)) return;
    // A disc's margin holds in all directions, a larger rectangle has corners beyond it.
    const double kept = std::max(0.0, GetParam() * M_SQRT1_2 - 1e-9);
    ASSERT_FALSE(ExactRectangle(site.grid, larger(site.robot, kept)).collides(pose)) << text(pose);
    gained += !site.checker.is_free(pose);
  });
  EXPECT_GT(gained, 20) << "poses where two discs do not fit";
}

TEST_P(SnugCollision, LetsThroughAllThatTheTwoDiscsDoAndAllThatFitsWithItsOverhang)
{
  for_poses(GetParam(), [&](const Site& site, const CollisionChecker& snug, const Pose& pose) {
    const bool fits = !ExactRectangle(site.grid, larger(site.robot, GetParam() + overhang(site.robot))).collides(pose);
    ASSERT_TRUE(snug.is_free(pose) || !(fits || site.checker.is_free(pose))) << text(pose);
  });
}

TEST_P(SnugCollision, KeepsTwoDiscsOfTheBodyClear)
{
  for_poses(GetParam(), [&](const Site& site, const CollisionChecker& snug, const Pose& pose) {
    if (!snug.is_free(pose)) return;
    for (double offset : {snug.discs().offset, -snug.discs().offset})
    {
      const Pose centre = compose(pose, {offset, 0.0, 0.0});
      ASSERT_GE(site.map.distance(centre.x, centre.y), snug.discs().radius) << text(pose);
    }
  });
}

TEST_P(SnugCollision, SaysByHowMuchAPoseIsFree)
{
  for_poses(GetParam(), [](const Site&, const CollisionChecker& snug, const Pose& pose) {
    ASSERT_EQ(snug.is_free(pose), snug.clearance(pose) >= 0.0) << text(pose);
  });
}

/// A robot that has come closer to a wall than its margin may go on there, and nowhere else.
TEST(TightPose, IsFreeAsFarAsTheBodyFitsAndOnlyAroundIt)
{
  OccupancyGrid grid = free_area(8.0, 4.0, 0.05);
  occupy_block(grid, 0, 0, 160, 20);
  const Site site(grid);
  const double closest = 1.0 + site.robot.width / 2.0 + overhang(site.robot);
  for (double left : {-0.002, 0.0005, 0.01, 0.03})
  {
    const Pose tight = {2.0, closest + left, 0.0}, far = {5.0, closest + left, 0.0};
    const CollisionChecker checker(site.map, site.robot, {tight});
    EXPECT_EQ(checker.is_free(tight), left > 0.0) << left;
    EXPECT_EQ(checker.is_free(far), left > site.robot.safety_margin) << left;
    EXPECT_FALSE(checker.is_free(Pose{2.0, tight.y - 0.005, 0.0}) && left < site.robot.safety_margin) << left;
  }
}

INSTANTIATE_TEST_SUITE_P(Margins, SnugCollision, testing::Values(0.0, 0.01, 0.02));

}  // namespace
}  // namespace fourwis
