#include "fourwis_navigation/vehicle/body.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fourwis
{
namespace
{

/// Corners closer than this are one [m].
constexpr double kSameCorner = 1e-12;

/// The points p with normal p <= offset; the normal has length one.
struct Side
{
  Point2 normal;
  double offset;

  double excess(const Point2& p) const { return normal.x * p.x + normal.y * p.y - offset; }
};

/// The side from a corner to the next.
Side side_of(const ConvexPolygon& polygon, std::size_t i)
{
  const Point2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
  const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
  const Point2 normal = {dy / length, -dx / length};
  return {normal, normal.x * from.x + normal.y * from.y};
}

/// What of a polygon lies on the inner side.
ConvexPolygon cut(const ConvexPolygon& polygon, const Side& side)
{
  ConvexPolygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double a = side.excess(from), b = side.excess(to);
    if (a <= 0.0) kept.push_back(from);
    if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0))
    {
      const double share = a / (a - b);
      kept.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
    }
  }
  return kept;
}

double signed_area(const ConvexPolygon& polygon)
{
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    area += (from.x * to.y - to.x * from.y) / 2.0;
  }
  return area;
}

/// The footprint in the frame of C, counter-clockwise.
ConvexPolygon footprint_of(const Robot& robot)
{
  ConvexPolygon corners;
  for (const Point2& corner : robot.footprint)
    corners.push_back({corner.x - robot.base_offset.x, corner.y - robot.base_offset.y});
  if (signed_area(corners) < 0.0) std::reverse(corners.begin(), corners.end());
  return corners;
}

}  // namespace

ConvexPolygon body_of(const Robot& robot)
{
  if (!robot.footprint.empty()) return footprint_of(robot);
  const double x = robot.length / 2.0, y = robot.width / 2.0;
  const Point2& middle = robot.body_offset;
  return {{middle.x + x, middle.y + y},
          {middle.x - x, middle.y + y},
          {middle.x - x, middle.y - y},
          {middle.x + x, middle.y - y}};
}

BodyBox box_of(const Robot& robot)
{
  if (robot.footprint.empty()) return {robot.length, robot.width, robot.body_offset};
  Extent x, y;
  for (const Point2& corner : body_of(robot)) x.add(corner.x), y.add(corner.y);
  return {x.greatest - x.least, y.greatest - y.least, {(x.least + x.greatest) / 2.0, (y.least + y.greatest) / 2.0}};
}

ConvexPolygon grown(const ConvexPolygon& polygon, double margin)
{
  if (polygon.size() < 3) return {};
  // Cut out of a square that holds all of the result but the tips of very sharp corners.
  const double far = 4.0 * (reach_of(polygon) + std::abs(margin));
  ConvexPolygon result = {{far, far}, {-far, far}, {-far, -far}, {far, -far}};
  for (std::size_t i = 0; i < polygon.size() && !result.empty(); ++i)
  {
    Side side = side_of(polygon, i);
    side.offset += margin;
    result = cut(result, side);
  }
  const auto same = [](const Point2& a, const Point2& b) { return std::hypot(a.x - b.x, a.y - b.y) < kSameCorner; };
  result.erase(std::unique(result.begin(), result.end(), same), result.end());
  if (result.size() > 1 && same(result.front(), result.back())) result.pop_back();
  if (result.size() < 3) result.clear();
  return result;
}

Extent extent_between(const Point2* corners, std::size_t count, double bottom, double top)
{
  Extent extent;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Point2 &from = corners[i], &to = corners[i + 1 == count ? 0 : i + 1];
    if (from.y >= bottom && from.y <= top) extent.add(from.x);
    for (double line : {bottom, top})
      if ((from.y < line) != (to.y < line)) extent.add(from.x + (line - from.y) / (to.y - from.y) * (to.x - from.x));
  }
  return extent;
}

double reach_of(const ConvexPolygon& polygon)
{
  double reach = 0.0;
  for (const Point2& corner : polygon) reach = std::max(reach, std::hypot(corner.x, corner.y));
  return reach;
}

double inner_radius_of(const ConvexPolygon& polygon)
{
  if (polygon.empty()) return 0.0;
  double radius = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) radius = std::min(radius, side_of(polygon, i).offset);
  return std::max(0.0, radius);
}

}  // namespace fourwis
