#include <gtest/gtest.h>

#include "../support/drive.h"
#include "../support/grids.h"
#include "../support/rectangle.h"
#include "fourwis_navigation/map/collision.h"

// A CollisionChecker that goes by the body itself where the two discs do not fit.

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 6;
/// A checker keeps this much at least, whatever the safety margin [m].
constexpr double kLeastMargin = 0.0005;
/// Accuracy of overlaps [m].
constexpr double kTouch = 1e-6;

Robot larger(Robot robot, double by)
{
  robot.length += 2.0 * by;
  robot.width += 2.0 * by;
  return robot;
}

/// Calls visit(site, checker, random) for cluttered maps, turned any way.
template <typename Visit>
void for_sites(double margin, Visit visit)
{
  Random random(kSeed);
  for (double resolution : {0.02, 0.05, 0.1})
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", resolution " + std::to_string(resolution));
    Robot robot;
    robot.safety_margin = margin;
    const Site site(clutter(random, 6.0, resolution, 14, random.pose(10.0)), robot);
    visit(site, CollisionChecker(site.map, site.robot, std::vector<Pose>()), random);
    if (testing::Test::HasFatalFailure()) return;
  }
}

/// Visits random poses.
template <typename Visit>
void for_poses(double margin, Visit visit)
{
  for_sites(margin, [&](const Site& site, const CollisionChecker& body, Random& random) {
    for (int k = 0; k < 2000; ++k)
    {
      visit(site, body,
            compose(site.grid.origin, {random.between(0.0, 6.0), random.between(0.0, 6.0), random.angle()}));
      if (testing::Test::HasFatalFailure()) return;
    }
  });
}

struct BodyCollision : testing::TestWithParam<double>
{
  double kept() const { return std::max(GetParam(), kLeastMargin); }
};

TEST_P(BodyCollision, LetsTheBodyWithItsMarginTouchNoObstacle)
{
  int gained = 0;
  for_poses(GetParam(), [&](const Site& site, const CollisionChecker& body, const Pose& pose) {
    if (!body.is_free(pose)) return;
    ASSERT_FALSE(ExactRectangle(site.grid, larger(site.robot, kept() - kTouch)).collides(pose)) << text(pose);
    gained += !site.checker.is_free(pose);
  });
  EXPECT_GT(gained, 20) << "poses where two discs do not fit";
}

TEST_P(BodyCollision, LetsThroughAllThatFitsWithItsMargin)
{
  for_poses(GetParam(), [&](const Site& site, const CollisionChecker& body, const Pose& pose) {
    const bool fits = !ExactRectangle(site.grid, larger(site.robot, kept() + kTouch)).collides(pose);
    ASSERT_TRUE(body.is_free(pose) || !fits) << text(pose);
  });
}

TEST_P(BodyCollision, KeepsWhatItsDiscsPromise)
{
  for_poses(GetParam(), [&](const Site& site, const CollisionChecker& body, const Pose& pose) {
    if (!body.is_free(pose)) return;
    for (double offset : {body.discs().offset, -body.discs().offset})
    {
      const Pose centre = compose(pose, {offset, 0.0, 0.0});
      ASSERT_GE(site.map.distance(centre.x, centre.y), body.discs().radius - kTouch) << text(pose);
    }
  });
}

/// Of the poses between a free one and another, the last free one.
Pose slid_towards(const CollisionChecker& checker, Pose free, Pose other)
{
  for (int k = 0; k < 40; ++k)
  {
    const Pose middle = {(free.x + other.x) / 2.0, (free.y + other.y) / 2.0, (free.theta + other.theta) / 2.0};
    (checker.is_free(middle) ? free : other) = middle;
  }
  return free;
}

/// Margins of half the least stride or more.
struct BodyCollisionWithMargin : BodyCollision
{};

/// Half a stride is what the body may lose between two checks.
TEST_P(BodyCollisionWithMargin, MotionsFoundFreeCanBeDrivenWithoutTheBodyTouchingAnything)
{
  for_sites(GetParam(), [](const Site& site, const CollisionChecker& body, Random& random) {
    const ExactRectangle rectangle(site.grid, site.robot);
    for (int k = 0; k < 60; ++k)
    {
      const Mode mode = kPlannedModes[static_cast<std::size_t>(k) % 3];
      const Pose free = free_pose(random, body), start = slid_towards(body, free, compose(free, random.pose(1.0)));
      const PathPiece piece = {mode, start, random.steering(site.robot, mode), random.between(-3.0, 3.0)};
      const double length = body.free_length(piece);
      const int steps = 1 + static_cast<int>(length / 0.005);
      for (int i = 0; i <= steps; ++i)
      {
        const double s = std::copysign(length * i / steps, piece.length);
        const Pose pose = drive_numerically(site.robot, piece.start, mode, piece.phi, s, 50);
        ASSERT_FALSE(rectangle.collides(pose)) << s << " m on, at " << text(pose);
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Margins, BodyCollision, testing::Values(0.0, 0.01, 0.02, 0.1));
INSTANTIATE_TEST_SUITE_P(Margins, BodyCollisionWithMargin, testing::Values(0.01, 0.02, 0.1));

/// A hall whose lower wall is a metre thick.
struct TightPose : testing::Test
{
  static OccupancyGrid hall()
  {
    OccupancyGrid grid = free_area(8.0, 4.0, 0.05);
    occupy_block(grid, 0, 0, 160, 20);
    return grid;
  }
  Pose beside_wall(double x, double gap) const { return {x, 1.0 + site.robot.width / 2.0 + gap, 0.0}; }

  const Site site{hall()};
};

/// A robot that has come closer to a wall than its margin may go on there, and nowhere else.
TEST_F(TightPose, IsFreeAsFarAsTheBodyFitsAndOnlyAroundIt)
{
  for (double gap : {0.0005, 0.01, 0.019, 0.03})
  {
    const Pose tight = beside_wall(2.0, gap), far = beside_wall(5.0, gap);
    const CollisionChecker checker(site.map, site.robot, {tight});
    EXPECT_TRUE(checker.is_free(tight)) << gap;
    EXPECT_EQ(checker.is_free(far), gap > site.robot.safety_margin) << gap;
    EXPECT_EQ(checker.is_free(beside_wall(2.5, gap - 0.0004)), gap > site.robot.safety_margin) << gap;
  }
}

TEST_F(TightPose, TouchingAWallIsFree)
{
  const Pose touching = beside_wall(2.0, 1e-9);
  const CollisionChecker checker(site.map, site.robot, {touching});
  EXPECT_TRUE(checker.is_free(touching));
  EXPECT_FALSE(checker.is_free(beside_wall(2.0, -0.001)));
}

TEST_F(TightPose, TheTighterOfTwoCountsNearBoth)
{
  const Pose tight = beside_wall(2.0, 0.004), less_tight = beside_wall(2.6, 0.015);
  for (const std::vector<Pose>& order : {std::vector<Pose>{tight, less_tight}, {less_tight, tight}})
  {
    const CollisionChecker checker(site.map, site.robot, order);
    EXPECT_TRUE(checker.is_free(tight));
    EXPECT_TRUE(checker.is_free(less_tight));
    EXPECT_TRUE(checker.is_free(beside_wall(2.3, 0.0045)));
    EXPECT_FALSE(checker.is_free(beside_wall(3.2, 0.0045))) << "near the less tight alone";
  }
}

}  // namespace
}  // namespace fourwis
