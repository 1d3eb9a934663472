#include "planner/certifier.h"

#include <gtest/gtest.h>

#include <limits>

#include "../support/grids.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "planner/stop_and_steer.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 77;

/// Least clearance of the clearest cover, by dense sampling of a piece.
double sampled_clearance(const ObstacleMap& map, const std::vector<DiscCover>& covers, const Robot& robot,
                         const PathPiece& piece)
{
  double least = 0.1;  // as far as the certificate looks
  for (int k = 0; k <= 4000; ++k)
  {
    const Pose pose = advance(robot, piece.start, piece.mode, piece.phi, piece.length * k / 4000);
    double clearest = -std::numeric_limits<double>::infinity();
    for (const DiscCover& discs : covers)
    {
      double clearance = std::numeric_limits<double>::infinity();
      for (const Point2& on_body : discs.centres)
      {
        const Pose centre = compose(pose, {on_body.x, on_body.y, 0.0});
        clearance = std::min(clearance, map.distance(centre.x, centre.y) - discs.radius);
      }
      clearest = std::max(clearest, clearance);
    }
    least = std::min(least, clearest);
  }
  return least;
}

TEST(CertifierTest, FindsTheLeastClearanceOfRandomMotions)
{
  const Robot robot;
  Random random(kSeed);
  for (int trial = 0; trial < 200; ++trial)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
    const OccupancyGrid grid = clutter(random, 6.0, 0.05, 6);
    const ObstacleMap map(grid);
    const DiscCover discs = without_margin(disc_cover(robot, random.whole(1, 6), random.whole(1, 3)), robot);
    const Mode mode = random.mode();
    const PathPiece piece = {mode, {3.0, 3.0, random.angle()}, random.steering(robot, mode), random.between(-1.0, 1.0)};
    const Path path = {{piece}, advance(robot, piece.start, mode, piece.phi, piece.length), 0.0};
    const Certificate certificate = Certifier(map, robot, {discs}).certify(stop_and_steer(path, robot, 1.0));
    const double found = certificate.least_clearance();
    const double sampled = sampled_clearance(map, {discs}, robot, piece);
    EXPECT_LE(found, sampled + 0.0015);
    if (sampled < 0.05)
      EXPECT_GE(found, sampled - 0.0015);
    else
      EXPECT_GE(found, 0.045);  // far away a lower bound will do
  }
}

TEST(CertifierTest, GoesByTheClearestOfSeveralCovers)
{
  const Robot robot;
  Random random(kSeed);
  const std::vector<DiscCover> covers = {without_margin(disc_cover(robot, 2), robot), snug_cover(robot)};
  int rescued = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
    const OccupancyGrid grid = clutter(random, 6.0, 0.05, 6);
    const ObstacleMap map(grid);
    const Mode mode = random.mode();
    const PathPiece piece = {mode, {3.0, 3.0, random.angle()}, random.steering(robot, mode), random.between(-0.6, 0.6)};
    const Path path = {{piece}, advance(robot, piece.start, mode, piece.phi, piece.length), 0.0};
    const Trajectory points = stop_and_steer(path, robot, 1.0);
    const double found = Certifier(map, robot, covers).certify(points).least_clearance();
    const double sampled = sampled_clearance(map, covers, robot, piece);
    EXPECT_LE(found, sampled + 0.0015);
    EXPECT_GE(found, std::min(sampled, 0.002) - 0.0015);  // where the first is clear the second is not looked at
    rescued += found > 0.0 && Certifier(map, robot, {covers.front()}).certify(points).least_clearance() < 0.0;
  }
  EXPECT_GT(rescued, 3) << "motions that only the second cover shows to be clear";
}

TEST(CertifierTest, NoticesAPointThatTheMotionMisses)
{
  const Robot robot;
  const ObstacleMap map(free_area(6.0, 6.0, 0.1));
  const DiscCover discs = without_margin(disc_cover(robot, 2), robot);
  const Path path = {{{Mode::ackermann, {2.0, 3.0, 0.0}, 0.2, 1.0}}, {}, 0.0};
  Trajectory points = stop_and_steer(path, robot, 1.0);
  const Certifier certifier(map, robot, {discs});
  EXPECT_LT(certifier.certify(points).worst_rollout, 1e-6);
  points[points.size() / 2].y += 0.007;
  EXPECT_NEAR(certifier.certify(points).worst_rollout, 0.007, 1e-5);
}

}  // namespace
}  // namespace fourwis
