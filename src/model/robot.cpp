#include "fourwis_navigation/model/robot.h"

#include <cstddef>

#include "fourwis_navigation/model/option_check.h"

namespace fourwis
{
namespace
{

/// More corners tell nothing new of a robot.
constexpr std::size_t kMostCorners = 32;
/// How far a wheel may lie outside by rounding, and how close corners may lie together [m].
constexpr double kRounding = 1e-6;

/// To the left of the line from a to b: distance of p times the length of the line [m^2].
double to_the_left(const Point2& a, const Point2& b, const Point2& p)
{
  return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

const Point2& next_corner(const std::vector<Point2>& polygon, std::size_t i)
{
  return polygon[(i + 1) % polygon.size()];
}

double twice_the_area(const std::vector<Point2>& polygon)
{
  double area = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    area += to_the_left(polygon.front(), polygon[i], next_corner(polygon, i));
  return area;
}

/// Every corner of a convex polygon lies on the same side of each of its sides.
bool is_convex(const std::vector<Point2>& polygon)
{
  const double sense = twice_the_area(polygon) > 0.0 ? 1.0 : -1.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    for (const Point2& corner : polygon)
    {
      const Point2& next = next_corner(polygon, i);
      const double length = std::hypot(next.x - polygon[i].x, next.y - polygon[i].y);
      if (sense * to_the_left(polygon[i], next, corner) < -kRounding * length) return false;
    }
  return true;
}

[[noreturn]] void reject_footprint(const Robot& robot, const std::string& expected)
{
  reject_option("footprint", PolygonText{0.0}.write(robot.footprint), expected);
}

void check_footprint(const Robot& robot)
{
  const std::vector<Point2>& corners = robot.footprint;
  if (corners.size() < 3 || corners.size() > kMostCorners)
    reject_footprint(robot, "3 to " + std::to_string(kMostCorners) + " corners, or none for the rectangle");
  for (std::size_t i = 0; i < corners.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (std::hypot(corners[k].x - corners[i].x, corners[k].y - corners[i].y) < kRounding)
        reject_footprint(robot, "corners that differ");
  if (!is_convex(corners)) reject_footprint(robot, "a convex polygon, its corners one after the other");
  if (robot.body_length() < 0.05 || robot.body_width() < 0.05) reject_footprint(robot, "an extent of 0.05 m or more");
}

/// A wheel outside the body would be invisible to every collision check.
void check_wheels_in_footprint(const Robot& robot)
{
  const double sense = twice_the_area(robot.footprint) > 0.0 ? 1.0 : -1.0;
  for (const WheelPosition& wheel : wheel_positions(robot))
  {
    const Point2 place = {robot.base_offset.x + wheel.x, robot.base_offset.y + wheel.y};
    for (std::size_t i = 0; i < robot.footprint.size(); ++i)
    {
      const Point2 &from = robot.footprint[i], &to = next_corner(robot.footprint, i);
      if (sense * to_the_left(from, to, place) < -kRounding * std::hypot(to.x - from.x, to.y - from.y))
        reject_footprint(robot,
                         "a polygon around the four wheels ('wheelbase', 'track_width', 'base_offset'): one is at " +
                             PointText{0.0}.write(place));
    }
  }
}

/// The same for the rectangle.
void check_axis_inside(const char* axis, double distance, double offset, const char* side, double extent)
{
  if (distance + 2.0 * std::abs(offset) <= extent + (offset != 0.0 ? kRounding : 0.0)) return;
  const std::string moved = offset != 0.0 ? ", moved by 'body_offset' (" + to_text(offset) + " m)" : "";
  reject_option(axis, to_text(distance),
                std::string("at most '") + side + "' (" + to_text(extent) + " m" + moved +
                    "): the wheels must lie within the body's rectangle");
}

template <double Point2::*Coordinate>
double extent_of(const std::vector<Point2>& polygon)
{
  double least = polygon.front().*Coordinate, greatest = least;
  for (const Point2& corner : polygon)
  {
    least = std::min(least, corner.*Coordinate);
    greatest = std::max(greatest, corner.*Coordinate);
  }
  return greatest - least;
}

}  // namespace

double Robot::body_length() const
{
  return footprint.empty() ? length : extent_of<&Point2::x>(footprint);
}

double Robot::body_width() const
{
  return footprint.empty() ? width : extent_of<&Point2::y>(footprint);
}

void check(const Robot& robot)
{
  check_ranges(robot);
  if (robot.footprint.empty())
  {
    check_axis_inside("wheelbase", robot.wheelbase, robot.body_offset.x, "length", robot.length);
    check_axis_inside("track_width", robot.track_width, robot.body_offset.y, "width", robot.width);
    return;
  }
  check_footprint(robot);
  check_wheels_in_footprint(robot);
}

}  // namespace fourwis
