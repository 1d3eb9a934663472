#include "fourwis_navigation/vehicle/body.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/random.h"

namespace fourwis
{
namespace
{

constexpr unsigned kSeed = 51;
constexpr double kAccuracy = 1e-9;

/// A convex polygon with corners on an ellipse, anywhere about C.
ConvexPolygon any_polygon(Random& random)
{
  std::vector<double> angles;
  for (int corners = random.whole(3, 9); corners > 0; --corners) angles.push_back(random.angle());
  std::sort(angles.begin(), angles.end());
  const double a = random.between(0.2, 2.0), b = random.between(0.2, 2.0), x = random.between(-1.0, 1.0),
               y = random.between(-1.0, 1.0);
  ConvexPolygon polygon;
  for (double angle : angles) polygon.push_back({x + a * std::cos(angle), y + b * std::sin(angle)});
  return polygon;
}

/// Sharp corners reach far: grown() cuts them off at 4 times the size. Sides must not be too short for exact directions.
bool is_blunt(const ConvexPolygon& polygon)
{
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()], &r = polygon[(i + 2) % polygon.size()];
    const double ax = q.x - p.x, ay = q.y - p.y, bx = r.x - q.x, by = r.y - q.y;
    if (std::hypot(ax, ay) < 0.02 || std::abs(std::atan2(ax * by - ay * bx, ax * bx + ay * by)) > 2.6) return false;
  }
  return true;
}

/// How far a point lies outside of the side that it lies outside of most; negative within the polygon [m].
double excess(const ConvexPolygon& polygon, const Point2& p)
{
  double most = -INFINITY;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double dx = b.x - a.x, dy = b.y - a.y;
    most = std::max(most, ((p.x - a.x) * dy - (p.y - a.y) * dx) / std::hypot(dx, dy));
  }
  return most;
}

template <typename Visit>
void for_polygons(Visit visit)
{
  Random random(kSeed);
  for (int k = 0; k < 600; ++k)
  {
    SCOPED_TRACE("seed " + std::to_string(kSeed) + ", polygon " + std::to_string(k));
    const ConvexPolygon polygon = any_polygon(random);
    if (is_blunt(polygon)) visit(polygon, random);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(Body, IsTheRectangleCounterClockwise)
{
  const ConvexPolygon body = body_of({});
  ASSERT_EQ(body.size(), 4u);
  double doubled_area = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(std::abs(body[i].x), 0.5);
    EXPECT_EQ(std::abs(body[i].y), 0.31);
    doubled_area += body[i].x * body[(i + 1) % 4].y - body[(i + 1) % 4].x * body[i].y;
  }
  EXPECT_NEAR(doubled_area, 2.0 * 1.0 * 0.62, kAccuracy);
}

TEST(Grown, HoldsThePointsThatLieOutsideOfNoSideByMoreThanTheMargin)
{
  int inside = 0, outside = 0;
  for_polygons([&](const ConvexPolygon& polygon, Random& random) {
    const double margin = random.between(-0.15, 0.4), reach = reach_of(polygon) + 0.5;
    const ConvexPolygon result = grown(polygon, margin);
    for (int k = 0; k < 100; ++k)
    {
      const Point2 p = {random.between(-reach, reach), random.between(-reach, reach)};
      const double beyond = excess(polygon, p) - margin;
      if (std::abs(beyond) < 1e-7) continue;
      ASSERT_EQ(!result.empty() && excess(result, p) < 0.0, beyond < 0.0) << p.x << ' ' << p.y << " margin " << margin;
      ++(beyond < 0.0 ? inside : outside);
    }
  });
  EXPECT_GT(inside, 5000);
  EXPECT_GT(outside, 5000);
}

TEST(Grown, OfARectangleIsALargerOne)
{
  const ConvexPolygon larger = grown(body_of({}), 0.1);
  ASSERT_EQ(larger.size(), 4u);
  for (const Point2& corner : larger)
  {
    EXPECT_NEAR(std::abs(corner.x), 0.6, kAccuracy);
    EXPECT_NEAR(std::abs(corner.y), 0.41, kAccuracy);
  }
}

TEST(Grown, ByNothingIsTheSamePolygonAndBackAgainToo)
{
  for_polygons([](const ConvexPolygon& polygon, Random& random) {
    const double margin = random.between(0.0, 0.4);
    for (const ConvexPolygon& same : {grown(polygon, 0.0), grown(grown(polygon, margin), -margin)})
      for (const Point2& corner : polygon) ASSERT_NEAR(excess(same, corner), 0.0, 1e-9);
  });
}

TEST(Grown, IsNothingWhereTheSidesMeet)
{
  const ConvexPolygon body = body_of({});
  EXPECT_EQ(grown(body, -0.3099).size(), 4u);
  EXPECT_TRUE(grown(body, -0.3101).empty());
  EXPECT_TRUE(grown(body, -0.31).empty());
  EXPECT_TRUE(grown(body, -100.0).empty());
  EXPECT_TRUE(grown({}, 1.0).empty());
}

TEST(Reach, IsThatOfTheFarthestCorner)
{
  EXPECT_NEAR(reach_of(body_of({})), std::hypot(0.5, 0.31), kAccuracy);
  EXPECT_NEAR(reach_of({{1.0, 0.0}, {0.0, 0.1}, {-3.0, -4.0}}), 5.0, kAccuracy);
  EXPECT_EQ(reach_of({}), 0.0);
}

TEST(InnerRadius, IsThatOfTheLargestDiscAboutCWithinThePolygon)
{
  EXPECT_NEAR(inner_radius_of(body_of({})), 0.31, kAccuracy);
  EXPECT_EQ(inner_radius_of({}), 0.0);
  int about_c = 0, beside_c = 0;
  for_polygons([&](const ConvexPolygon& polygon, Random&) {
    const double radius = inner_radius_of(polygon);
    // All points of a slightly smaller circle lie within, some of a slightly larger one do not.
    double farthest = -INFINITY;
    for (int k = 0; k < 3600; ++k)
    {
      const double angle = k * M_PI / 1800.0;
      farthest = std::max(farthest, excess(polygon, {radius * std::cos(angle), radius * std::sin(angle)}));
    }
    const bool has_c = excess(polygon, {0.0, 0.0}) < 0.0;
    if (has_c)
      ASSERT_NEAR(farthest, 0.0, 1e-5);
    else
      ASSERT_EQ(radius, 0.0);
    ++(has_c ? about_c : beside_c);
  });
  EXPECT_GT(about_c, 50);
  EXPECT_GT(beside_c, 50);
}

}  // namespace
}  // namespace fourwis
