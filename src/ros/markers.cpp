#include "markers.h"

#include <cmath>
#include <string>

#include "conversions.h"
#include "fourwis_navigation/corridor/polytope_corridor.h"
#include "fourwis_navigation/model/mode_colour.h"
#include "fourwis_navigation/vehicle/base_link.h"
#include "fourwis_navigation/vehicle/body.h"

namespace fourwis
{
namespace
{

using visualization_msgs::Marker;

/// Heights at which things lie above the map, so that what matters more is not hidden [m].
constexpr double kCorridorHeight = 0.005, kFootprintHeight = 0.01, kExpansionHeight = 0.02, kPathHeight = 0.03,
                 kEndHeight = 0.04;

/// A footprint is drawn where the robot has moved by this [m] or turned by this [rad] since the one before.
constexpr double kFootprintStep = 0.4, kFootprintTurn = 0.35;

std_msgs::ColorRGBA colour(float r, float g, float b, float a)
{
  std_msgs::ColorRGBA colour;
  colour.r = r;
  colour.g = g;
  colour.b = b;
  colour.a = a;
  return colour;
}

std_msgs::ColorRGBA colour_of(Mode mode, float alpha)
{
  const Colour& parts = colour_of(mode);
  const auto share = [](std::uint8_t part) { return static_cast<float>(part) / 255.0f; };
  return colour(share(parts.red), share(parts.green), share(parts.blue), alpha);
}

constexpr double kTextSize = 0.4;

/// Regions are drawn within a square of this half side around the plan [m]; no plan is as long.
constexpr double kCorridorReach = 2e4;

const std_msgs::ColorRGBA kStartColour = colour(0.3f, 0.3f, 0.3f, 1.0f);
const std_msgs::ColorRGBA kGoalColour = colour(0.84f, 0.15f, 0.16f, 1.0f);
const std_msgs::ColorRGBA kSwitchColour = colour(0.8f, 0.1f, 0.8f, 1.0f);
/// Nearly transparent, because neighbouring regions overlap.
const std_msgs::ColorRGBA kCorridorColour = colour(0.0f, 0.64f, 0.71f, 0.06f);

geometry_msgs::Point point(const Pose& pose, double height)
{
  geometry_msgs::Point point;
  point.x = pose.x;
  point.y = pose.y;
  point.z = height;
  return point;
}

Marker marker(const std::string& name, int type, double size, const std_msgs::Header& header)
{
  Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = size;
  marker.color = colour(1.0f, 1.0f, 1.0f, 1.0f);
  return marker;
}

/// rviz complains about a list without points; what is not there is removed instead.
Marker finished(Marker marker)
{
  if (marker.points.empty()) marker.action = Marker::DELETE;
  return marker;
}

void add_line(const Pose& from, const Pose& to, double height, const std_msgs::ColorRGBA& colour, Marker& lines)
{
  lines.points.push_back(point(from, height));
  lines.points.push_back(point(to, height));
  lines.colors.insert(lines.colors.end(), 2, colour);
}

/// The body with base_link at a pose, and a line from C, the centre of the wheels, to its front.
void add_footprint(const Robot& robot, const Pose& pose, double height, const std_msgs::ColorRGBA& colour,
                   Marker& lines)
{
  const Pose centre = BaseLink(robot).to_centre(pose);
  const ConvexPolygon body = body_of(robot);
  const auto at = [&](const Point2& point) { return compose(centre, {point.x, point.y, 0.0}); };
  for (std::size_t i = 0; i < body.size(); ++i)
    add_line(at(body[i]), at(body[(i + 1) % body.size()]), height, colour, lines);
  const BodyBox box = box_of(robot);
  add_line(centre, at({box.middle.x + box.length / 2.0, box.middle.y}), height, colour, lines);
}

Marker path_marker(const Trajectory& trajectory, const std_msgs::Header& header)
{
  Marker lines = marker("path", Marker::LINE_LIST, 0.05, header);
  for (std::size_t i = 1; i < trajectory.size(); ++i)
  {
    if (trajectory[i].mode != trajectory[i - 1].mode) continue;
    add_line(trajectory[i - 1].pose(), trajectory[i].pose(), kPathHeight, colour_of(trajectory[i].mode, 1.0f), lines);
  }
  return finished(lines);
}

Marker footprint_marker(const Robot& robot, const Trajectory& trajectory, const std_msgs::Header& header)
{
  Marker lines = marker("footprints", Marker::LINE_LIST, 0.015, header);
  const TrajectoryPoint* last = nullptr;
  for (const TrajectoryPoint& next : trajectory)
  {
    if (last && last->mode == next.mode && distance(last->pose(), next.pose()) < kFootprintStep &&
        std::abs(next.theta - last->theta) < kFootprintTurn)
      continue;
    add_footprint(robot, next.pose(), kFootprintHeight, colour_of(next.mode, 0.6f), lines);
    last = &next;
  }
  return finished(lines);
}

Marker switch_marker(const Trajectory& trajectory, const std_msgs::Header& header)
{
  Marker spheres = marker("switches", Marker::SPHERE_LIST, 0.2, header);
  spheres.color = kSwitchColour;
  for (std::size_t i = 1; i < trajectory.size(); ++i)
    if (trajectory[i].mode != trajectory[i - 1].mode)
      spheres.points.push_back(point(trajectory[i].pose(), kPathHeight));
  return finished(spheres);
}

void add_region(const Polytope& region, const Pose& around, Marker& triangles)
{
  const std::vector<Point2> polygon = corners(region, {around.x, around.y}, kCorridorReach);
  for (std::size_t i = 2; i < polygon.size(); ++i)
    for (const Point2& corner : {polygon[0], polygon[i - 1], polygon[i]})
      triangles.points.push_back(point({corner.x, corner.y, 0.0}, kCorridorHeight));
}

Marker end_marker(const std::string& name, const Robot& robot, const Pose& pose, const std_msgs::ColorRGBA& colour,
                  const std_msgs::Header& header)
{
  Marker lines = marker(name, Marker::LINE_LIST, 0.04, header);
  add_footprint(robot, pose, kEndHeight, colour, lines);
  return lines;
}

}  // namespace

visualization_msgs::MarkerArray plan_markers(const Robot& robot, const PlanRequest& request,
                                             const Trajectory& trajectory, const std_msgs::Header& header)
{
  visualization_msgs::MarkerArray array;
  array.markers = {path_marker(trajectory, header), footprint_marker(robot, trajectory, header),
                   switch_marker(trajectory, header), end_marker("start", robot, request.start, kStartColour, header),
                   end_marker("goal", robot, request.goal, kGoalColour, header)};
  // The plan before it may have failed.
  array.markers.push_back(finished(marker("failure", Marker::TEXT_VIEW_FACING, kTextSize, header)));
  return array;
}

visualization_msgs::Marker failure_marker(const Pose& goal, PlanStatus status, const std_msgs::Header& header)
{
  Marker text = marker("failure", Marker::TEXT_VIEW_FACING, kTextSize, header);
  text.color = kGoalColour;
  text.pose.position = point(goal, kEndHeight);
  text.text = to_string(status);
  return text;
}

visualization_msgs::Marker corridor_marker(const std::vector<Corridor>& corridors, const Pose& around,
                                           const std_msgs::Header& header)
{
  Marker triangles = marker("corridors", Marker::TRIANGLE_LIST, 1.0, header);
  triangles.color = kCorridorColour;
  for (const Corridor& corridor : corridors)
    for (const DiscRegions& disc : corridor)
      for (const Polytope& region : disc.regions) add_region(region, around, triangles);
  return finished(triangles);
}

visualization_msgs::Marker iteration_marker(const std::vector<Trajectory>& iterations, const std_msgs::Header& header)
{
  Marker lines = marker("iterations", Marker::LINE_LIST, 0.015, header);
  float alpha = 0.1f;
  for (const Trajectory& iteration : iterations)
  {
    alpha += 0.9f / static_cast<float>(iterations.size());
    for (std::size_t i = 1; i < iteration.size(); ++i)
      add_line(iteration[i - 1].pose(), iteration[i].pose(), kPathHeight, colour(0.48f, 0.25f, 0.7f, alpha), lines);
  }
  return finished(lines);
}

visualization_msgs::Marker expansion_marker(const PlanTrace& trace, const std_msgs::Header& header)
{
  Marker points = marker("expansions", Marker::POINTS, 0.04, header);
  points.color = colour(0.2f, 0.7f, 0.8f, 0.7f);
  points.points.reserve(trace.expanded.size());
  for (const Pose& pose : trace.expanded) points.points.push_back(point(pose, kExpansionHeight));
  return finished(points);
}

}  // namespace fourwis
