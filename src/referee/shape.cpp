#include "shape.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fourwis::referee
{
namespace
{

/// Corners closer than this are one [m].
constexpr double kSame = 1e-13;

double cross(const Point2& a, const Point2& b)
{
  return a.x * b.y - a.y * b.x;
}

double dot(const Point2& a, const Point2& b)
{
  return a.x * b.x + a.y * b.y;
}

/// Without sides of no length.
Shape shape_of(const std::vector<Point2>& corners)
{
  Shape shape;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Point2 &from = corners[i], &to = corners[(i + 1) % corners.size()];
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
    if (length < kSame) continue;
    shape.corners.push_back(from);
    shape.normals.push_back({dy / length, -dx / length});
  }
  return shape.corners.size() < 3 ? Shape{} : shape;
}

/// What of the polygon has normal * p <= offset.
std::vector<Point2> cut(const std::vector<Point2>& polygon, const Point2& normal, double offset)
{
  std::vector<Point2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const double before = dot(normal, from) - offset, after = dot(normal, to) - offset;
    if (before <= 0.0) kept.push_back(from);
    if ((before < 0.0) == (after < 0.0) || before == 0.0 || after == 0.0) continue;
    const double share = before / (before - after);
    kept.push_back({from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)});
  }
  return kept;
}

}  // namespace

Shape body_shape(const Robot& robot)
{
  std::vector<Point2> corners;
  for (const Point2& corner : robot.footprint)
    corners.push_back({corner.x - robot.base_offset.x, corner.y - robot.base_offset.y});
  if (corners.empty())
    for (const auto& [front, left] : {std::pair{0.5, 0.5}, {-0.5, 0.5}, {-0.5, -0.5}, {0.5, -0.5}})
      corners.push_back({robot.body_offset.x + front * robot.length, robot.body_offset.y + left * robot.width});
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) area += cross(corners[i], corners[(i + 1) % corners.size()]);
  if (area < 0.0) std::reverse(corners.begin(), corners.end());
  return shape_of(corners);
}

Shape inset(const Shape& shape, double depth)
{
  std::vector<Point2> corners = shape.corners;
  for (std::size_t i = 0; i < shape.normals.size(); ++i)
    corners = cut(corners, shape.normals[i], dot(shape.normals[i], shape.corners[i]) - depth);
  return shape_of(corners);
}

double greatest_radius(const Shape& shape)
{
  double radius = 0.0;
  for (const Point2& corner : shape.corners) radius = std::max(radius, std::hypot(corner.x, corner.y));
  return radius;
}

}  // namespace fourwis::referee
