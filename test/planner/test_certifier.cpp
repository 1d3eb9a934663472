#include "planner/certifier.h"

#include <gtest/gtest.h>

#include <limits>

#include "../support/grids.h"
#include "../support/rectangle.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "planner/stop_and_steer.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 77;
/// By how much the certificate may be wrong [m].
constexpr double kAccuracy = 0.0015;

/// The body with as much margin as the certificate tells apart [m].
class MarginsOfBody
{
public:
  explicit MarginsOfBody(const OccupancyGrid& grid)
  {
    for (double margin : {0.01, 0.004, 0.002, 0.001})
    {
      Robot larger;
      larger.length += 2.0 * margin;
      larger.width += 2.0 * margin;
      margins_.push_back({margin, ExactRectangle(grid, larger)});
    }
  }

  /// The greatest at which the body is clear; -infinity where it is at none.
  double at(const Pose& pose) const
  {
    for (const auto& [margin, rectangle] : margins_)
      if (!rectangle.collides(pose)) return margin;
    return -std::numeric_limits<double>::infinity();
  }

private:
  std::vector<std::pair<double, ExactRectangle>> margins_;
};

double disc_clearance(const ObstacleMap& map, const DiscCover& discs, const Pose& pose)
{
  double clearance = std::numeric_limits<double>::infinity();
  for (const Point2& on_body : discs.centres)
  {
    const Pose centre = compose(pose, {on_body.x, on_body.y, 0.0});
    clearance = std::min(clearance, map.distance(centre.x, centre.y) - discs.radius);
  }
  return clearance;
}

/// Least clearance by dense sampling of a piece; at each pose the larger of what the discs and what the body have.
double sampled_clearance(const ObstacleMap& map, const DiscCover& discs, const MarginsOfBody& body,
                         const PathPiece& piece)
{
  double least = 0.1;  // as far as the certificate looks
  for (int k = 0; k <= 2000; ++k)
  {
    const Pose pose = advance({}, piece.start, piece.mode, piece.phi, piece.length * k / 2000);
    const double clearance = disc_clearance(map, discs, pose);
    least = std::min(least, clearance < 0.01 ? std::max(clearance, body.at(pose)) : clearance);
  }
  return least;
}

Path path_of(const PathPiece& piece)
{
  Path path;
  path.pieces = {piece};
  path.goal = advance({}, piece.start, piece.mode, piece.phi, piece.length);
  return path;
}

TEST(CertifierTest, FindsTheLeastClearanceOfRandomMotions)
{
  const Robot robot;
  Random random(kSeed);
  int by_body = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", trial " + std::to_string(trial));
    const OccupancyGrid grid = clutter(random, 6.0, 0.05, 6);
    const ObstacleMap map(grid);
    const DiscCover discs = without_margin(disc_cover(robot, random.whole(1, 6), random.whole(1, 3)), robot);
    const Mode mode = random.mode();
    const PathPiece piece = {mode, {3.0, 3.0, random.angle()}, random.steering(robot, mode), random.between(-1.0, 1.0)};
    const double found = Certifier(map, robot, discs).certify(stop_and_steer(path_of(piece), robot)).least_clearance();
    const double sampled = sampled_clearance(map, discs, MarginsOfBody(grid), piece);
    // A body that grazes a margin somewhere between two samples may be told the next smaller one.
    const double lowest = sampled <= 0.01 && sampled > 0.0 ? sampled / 2.5 : sampled;
    EXPECT_LE(found, sampled + kAccuracy);
    if (sampled < 0.05)
      EXPECT_GE(found, lowest - kAccuracy);
    else
      EXPECT_GE(found, 0.045);  // far away a lower bound will do
    by_body += found > 0.0 && found <= 0.01;
  }
  EXPECT_GT(by_body, 3) << "motions of which the body shows that they are clear";
}

/// What is certified with the discs alone is certified with the body as well, and more: they are wider than it is.
TEST(CertifierTest, LetsTheBodyGoWhereTwoDiscsDoNotFit)
{
  OccupancyGrid grid = free_area(6.0, 4.0, 0.05);
  occupy_block(grid, 0, 0, 120, 20);
  const ObstacleMap map(grid);
  const Robot robot;
  const DiscCover discs = without_margin(disc_cover(robot, 2), robot);
  const double side = robot.width / 2.0;
  for (const auto& [gap, margin] : {std::pair(0.0101, 0.01), {0.0099, 0.004}, {0.0021, 0.002}, {0.0011, 0.001}})
  {
    const PathPiece piece = {Mode::ackermann, {1.5, 1.0 + side + gap, 0.0}, 0.0, 2.0};
    EXPECT_EQ(Certifier(map, robot, discs).certify(stop_and_steer(path_of(piece), robot)).least_clearance(), margin)
        << gap;
  }
  for (double gap : {0.0009, 0.0, -0.01})
  {
    const PathPiece piece = {Mode::ackermann, {1.5, 1.0 + side + gap, 0.0}, 0.0, 2.0};
    EXPECT_LT(Certifier(map, robot, discs).certify(stop_and_steer(path_of(piece), robot)).least_clearance(), 0.0)
        << gap;
  }
}

TEST(CertifierTest, NoticesAPointThatTheMotionMisses)
{
  const Robot robot;
  const ObstacleMap map(free_area(6.0, 6.0, 0.1));
  const DiscCover discs = without_margin(disc_cover(robot, 2), robot);
  Trajectory points = stop_and_steer(path_of({Mode::ackermann, {2.0, 3.0, 0.0}, 0.2, 1.0}), robot);
  const Certifier certifier(map, robot, discs);
  EXPECT_LT(certifier.certify(points).worst_rollout, 1e-6);
  points[points.size() / 2].y += 0.007;
  EXPECT_NEAR(certifier.certify(points).worst_rollout, 0.007, 1e-5);
}

}  // namespace
}  // namespace fourwis
