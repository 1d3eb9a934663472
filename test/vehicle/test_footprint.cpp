#include "fourwis_navigation/vehicle/footprint.h"

#include <gtest/gtest.h>

#include "../support/exact_polygon.h"
#include "fourwis_navigation/vehicle/body.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 5;

/// The centred rectangle, one that is moved, and polygons.
Robot any_robot(Random& random, int k)
{
  Robot robot;
  if (k % 3 == 1) robot.body_offset = {random.between(-0.15, 0.15), random.between(-0.04, 0.04)};
  if (k % 3 == 2) robot = polygon_robot(random);
  robot.safety_margin = random.between(0.0, 0.1);
  return robot;
}

/// Points of the body in the frame of C: on its edges and within.
template <typename Visit>
void for_body_points(const Robot& robot, Random& random, Visit visit)
{
  const ConvexPolygon body = body_of(robot);
  for (int k = 0; k < 300; ++k)
  {
    const Point2 &a = body[static_cast<std::size_t>(random.whole(0, static_cast<int>(body.size()) - 1))],
                 &b = body[static_cast<std::size_t>(random.whole(0, static_cast<int>(body.size()) - 1))];
    const double share = random.between(0.0, 1.0);
    visit(Point2{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)});
  }
}

double distance_of(const Point2& a, const Point2& b)
{
  return std::hypot(a.x - b.x, a.y - b.y);
}

TEST(Footprints, AreCoveredByTheirDiscs)
{
  Random random(kSeed);
  for (int k = 0; k < 150; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", robot " + std::to_string(k));
    const Robot robot = any_robot(random, k);
    const TwoDiscs two = two_discs(robot);
    const Point2 front = {two.middle.x + two.offset, two.middle.y}, rear = {two.middle.x - two.offset, two.middle.y};
    const DiscCover cover = disc_cover(robot, random.whole(1, 6), random.whole(1, 3));
    for_body_points(robot, random, [&](const Point2& p) {
      ASSERT_LE(std::min(distance_of(p, front), distance_of(p, rear)), two.radius - robot.safety_margin + 1e-12);
      double nearest = INFINITY;
      for (const Point2& centre : cover.centres) nearest = std::min(nearest, distance_of(p, centre));
      ASSERT_LE(nearest, cover.radius - robot.safety_margin + 1e-12);
    });
    EXPECT_NEAR(two.reach(), std::max(std::hypot(front.x, front.y), std::hypot(rear.x, rear.y)), 1e-12);
  }
}

/// Otherwise poses that are free would be taken for collisions.
TEST(Footprints, HoldTheirInscribedDiscs)
{
  Random random(kSeed);
  for (int k = 0; k < 150; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", robot " + std::to_string(k));
    const Robot robot = any_robot(random, k);
    const TwoDiscs discs = inscribed_discs(robot, 0.0);
    const ConvexPolygon body = body_of(robot);
    EXPECT_GT(discs.radius, 0.2);
    for (double offset : {discs.offset, -discs.offset})
      for (std::size_t i = 0; i < body.size(); ++i)
      {
        const Point2 &a = body[i], &b = body[(i + 1) % body.size()];
        const double inside =
            ((b.x - a.x) * (discs.middle.y - a.y) - (b.y - a.y) * (discs.middle.x + offset - a.x)) / distance_of(a, b);
        ASSERT_GE(inside, discs.radius - 1e-9);
      }
    EXPECT_NEAR(inscribed_discs(robot, 0.07).radius, discs.radius + 0.07, 1e-12);
  }
}

TEST(Footprints, OfTheDefaultRobotHaveThePapersDiscs)
{
  const TwoDiscs discs = two_discs(Robot());
  EXPECT_EQ(discs.offset, 0.25);
  EXPECT_EQ(discs.radius, std::hypot(0.25, 0.31) + 0.02);
  EXPECT_EQ(discs.middle.x, 0.0);
  EXPECT_EQ(disc_cover(Robot(), 2).radius, discs.radius);
}

TEST(Footprints, AreTurnedCounterClockwiseAndMovedToTheFrameOfTheWheels)
{
  Robot robot;
  robot.base_offset = {0.34, 0.0};
  robot.footprint = {{-0.2, -0.3}, {-0.2, 0.3}, {0.9, 0.3}, {0.9, -0.3}};
  const ConvexPolygon body = body_of(robot);
  ASSERT_EQ(body.size(), 4u);
  double area = 0.0;
  for (std::size_t i = 0; i < 4; ++i) area += (body[i].x * body[(i + 1) % 4].y - body[(i + 1) % 4].x * body[i].y) / 2.0;
  EXPECT_NEAR(area, 1.1 * 0.6, 1e-12);
  const BodyBox box = box_of(robot);
  EXPECT_NEAR(box.middle.x, 0.01, 1e-12);
  EXPECT_NEAR(box.length, 1.1, 1e-12);
}

}  // namespace
}  // namespace fourwis
