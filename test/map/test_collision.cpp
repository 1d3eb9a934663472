#include "fourwis_navigation/map/collision.h"

#include <gtest/gtest.h>

#include <limits>

#include "../support/drive.h"
#include "../support/grids.h"
#include "../support/rectangle.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 5;
constexpr double kResolutions[] = {0.02, 0.03, 0.05, 0.1, 0.15, 0.3};

Robot with_margin(double margin)
{
  Robot robot;
  robot.safety_margin = margin;
  return robot;
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

/// Calls visit(site) for cluttered maps of all resolutions, turned any way.
template <typename Visit>
void for_sites(double margin, Visit visit)
{
  Random random(kSeed);
  for (double resolution : kResolutions)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", resolution " + std::to_string(resolution));
    visit(Site(clutter(random, 6.0, resolution, 12, random.pose(10.0)), with_margin(margin)), random);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(APoseFoundFree, NeverHasTheRectangleInAnObstacleHoweverCloseItIs)
{
  for_sites(0.0, [](const Site& site, Random& random) {
    const ExactRectangle rectangle(site.grid, site.robot);
    for (int k = 0; k < 150; ++k)
    {
      const Pose free = free_pose(random, site.checker), target = compose(free, random.pose(2.0));
      const Pose pose = slid_towards(site.checker, free, target);
      ASSERT_TRUE(site.checker.is_free(pose)) << text(pose);
      ASSERT_FALSE(rectangle.collides(pose)) << text(pose);
    }
  });
}

TEST(APoseFoundFree, IsOneWhoseTwoDiscCentresAreFarEnoughFromObstacles)
{
  for_sites(0.02, [](const Site& site, Random& random) {
    const TwoDiscs discs = site.checker.discs();
    int free = 0;
    for (int k = 0; k < 1000; ++k)
    {
      const Pose pose = compose(site.grid.origin, {random.between(0.0, 6.0), random.between(0.0, 6.0), random.angle()});
      const Pose front = compose(pose, {discs.offset, 0.0, 0.0}), rear = compose(pose, {-discs.offset, 0.0, 0.0});
      const double least = std::min(site.map.distance(front.x, front.y), site.map.distance(rear.x, rear.y));
      ASSERT_EQ(site.checker.is_free(pose), least >= discs.radius) << text(pose);
      free += site.checker.is_free(pose);
    }
    ASSERT_GT(free, 20);
  });
}

TEST(APoseFoundFree, LooksTheSameFromBehind)
{
  for_sites(0.02, [](const Site& site, Random& random) {
    for (int k = 0; k < 500; ++k)
    {
      Pose pose = compose(site.grid.origin, {random.between(0.0, 6.0), random.between(0.0, 6.0), random.angle()});
      const bool free = site.checker.is_free(pose);
      pose.theta += M_PI;
      ASSERT_EQ(site.checker.is_free(pose), free) << text(pose);
    }
  });
}

TEST(APoseFoundFree, IsANumberAndLiesOnTheMap)
{
  const Site site(free_area(4.0, 4.0, 0.1));
  EXPECT_TRUE(site.checker.is_free(Pose{2.0, 2.0, 1.0}));
  const double nan = std::nan("");
  for (const Pose& pose : {Pose{nan, 2.0, 0.0}, Pose{2.0, nan, 0.0}, Pose{2.0, 2.0, nan}, Pose{0.0, 0.0, 0.0},
                           Pose{-5.0, 2.0, 0.0}, Pose{1e300, 2.0, 0.0}})
    EXPECT_FALSE(site.checker.is_free(pose)) << text(pose);
}

/// Motions of all modes from free poses, most of which end at an obstacle.
struct FreeLength : testing::TestWithParam<double>
{
  template <typename Visit>
  void for_pieces(Visit visit) const
  {
    for_sites(GetParam(), [&](const Site& site, Random& random) {
      for (int k = 0; k < 40; ++k)
      {
        const Mode mode = kPlannedModes[static_cast<std::size_t>(k) % 3];
        const PathPiece piece = {mode, free_pose(random, site.checker), random.steering(site.robot, mode),
                                 random.between(-3.0, 3.0)};
        SCOPED_TRACE(std::string(to_string(mode)) + " from " + text(piece.start) + " phi " + std::to_string(piece.phi) +
                     " length " + std::to_string(piece.length));
        visit(site, piece, site.checker.free_length(piece));
        if (HasFatalFailure()) return;
      }
    });
  }

  static Pose at(const Site& site, const PathPiece& piece, double s)
  {
    return drive_numerically(site.robot, piece.start, piece.mode, piece.phi, std::copysign(s, piece.length), 50);
  }
};

TEST_P(FreeLength, IsBetweenNothingAndTheWholePiece)
{
  for_pieces([](const Site& site, const PathPiece& piece, double free) {
    ASSERT_GE(free, 0.0);
    ASSERT_LE(free, std::abs(piece.length));
    ASSERT_EQ(site.checker.is_free(piece), free == std::abs(piece.length));
  });
}

TEST_P(FreeLength, CanBeDrivenWithoutTheRectangleTouchingAnything)
{
  for_pieces([](const Site& site, const PathPiece& piece, double free) {
    const ExactRectangle rectangle(site.grid, site.robot);
    const int steps = 1 + static_cast<int>(free / 0.01);
    for (int k = 0; k <= steps; ++k)
    {
      const Pose pose = at(site, piece, free * k / steps);
      ASSERT_FALSE(rectangle.collides(pose)) << free * k / steps << " m on, at " << text(pose);
    }
  });
}

/// Clearance of the two disc centres [m].
double disc_clearance(const Site& site, const Pose& pose)
{
  const double offset = site.checker.discs().offset;
  const Pose front = compose(pose, {offset, 0.0, 0.0}), rear = compose(pose, {-offset, 0.0, 0.0});
  return std::min(site.map.distance(front.x, front.y), site.map.distance(rear.x, rear.y));
}

TEST_P(FreeLength, KeepsTheLeastClearanceBetweenTheChecksAndNotMuchMore)
{
  double least = std::numeric_limits<double>::infinity(), promised = 0.0, radius = 0.0;
  for_sites(GetParam(), [&](const Site& site, Random& random) {
    promised = site.checker.least_clearance(), radius = site.checker.discs().radius;
    for (int k = 0; k < 400; ++k)
    {
      const Mode mode = kPlannedModes[static_cast<std::size_t>(k) % 3];
      const Pose free = free_pose(random, site.checker);
      const PathPiece piece = {mode, slid_towards(site.checker, free, compose(free, random.pose(1.0))),
                               random.steering(site.robot, mode), random.between(-3.0, 3.0)};
      const Arc arc(site.robot, piece.start, mode, piece.phi);
      const double length = site.checker.free_length(piece);
      for (double s = 0.0; s < length; s += 0.001)
        least = std::min(least, disc_clearance(site, arc.pose(std::copysign(s, piece.length))));
    }
  });
  EXPECT_GE(least, promised - 1e-9);
  EXPECT_LT(least, radius - 0.1 * (radius - promised));
}

TEST_P(FreeLength, EndsAtAFreePose)
{
  for_pieces([](const Site& site, const PathPiece& piece, double free) {
    ASSERT_TRUE(site.checker.is_free(
        advance(site.robot, piece.start, piece.mode, piece.phi, std::copysign(free, piece.length))));
  });
}

TEST_P(FreeLength, EndsWithinAStrideOfACollision)
{
  int stopped = 0;
  for_pieces([&](const Site& site, const PathPiece& piece, double free) {
    if (free == std::abs(piece.length)) return;
    ++stopped;
    const double reach = std::min(site.checker.stride(), std::abs(piece.length) - free);
    bool collides = false;
    for (int k = 1; k <= 100; ++k) collides |= !site.checker.is_free(at(site, piece, free + reach * k / 100.0));
    ASSERT_TRUE(collides) << free << " m are free, and more";
  });
  EXPECT_GT(stopped, 50);
}

TEST_P(FreeLength, IsNoneFromACollision)
{
  Robot robot = with_margin(GetParam());
  OccupancyGrid grid = free_area(5.0, 5.0, 0.05);
  occupy_block(grid, 50, 50, 1, 1);
  const Site site(grid, robot);
  for (Mode mode : kPlannedModes)
    for (double length : {-1.0, 0.5, 2.0})
      EXPECT_EQ(site.checker.free_length({mode, {2.5, 2.5, 0.3}, 0.1, length}), 0.0);
}

TEST_P(FreeLength, IsTheWholePieceInTheOpen)
{
  const Site site(free_area(12.0, 12.0, 0.1), with_margin(GetParam()));
  for (Mode mode : kPlannedModes)
    for (double length : {-4.0, -1e-9, 0.0, 1e-9, 0.5, 4.0})
    {
      const PathPiece piece = {mode, {6.0, 6.0, 0.3}, 0.1, length};
      EXPECT_EQ(site.checker.free_length(piece), std::abs(length));
      EXPECT_TRUE(site.checker.is_free(piece));
    }
}

// The least margin with which free_length() promises anything about the body is half its stride.
INSTANTIATE_TEST_SUITE_P(SafetyMargins, FreeLength, testing::Values(0.005, 0.02, 0.06));

}  // namespace
}  // namespace fourwis
