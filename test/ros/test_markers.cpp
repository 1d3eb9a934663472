#include <cmath>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "ros/markers.h"

namespace fourwis
{
namespace
{

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

TrajectoryPoint point(double t, Mode mode, double x, double y)
{
  TrajectoryPoint point;
  point.t = t;
  point.mode = mode;
  point.x = x;
  point.y = y;
  return point;
}

/// Forward, sideways, forward again.
Trajectory switching_trajectory()
{
  return {point(0, Mode::ackermann, 0, 0), point(2, Mode::ackermann, 2, 0), point(3, Mode::lateral, 2, 0),
          point(5, Mode::lateral, 2, 1),   point(6, Mode::parallel, 2, 1),  point(8, Mode::parallel, 4, 1)};
}

const Marker& named(const MarkerArray& array, const std::string& name)
{
  for (const Marker& marker : array.markers)
    if (marker.ns == name) return marker;
  throw std::runtime_error("no marker called " + name);
}

MarkerArray markers(const Trajectory& trajectory)
{
  std_msgs::Header header;
  header.frame_id = "map";
  return plan_markers(Robot(), {{0, 0, 0}, {4, 1, 0}, {}}, trajectory, header);
}

std::set<std::string> colours(const Marker& marker)
{
  std::set<std::string> result;
  for (const auto& c : marker.colors)
    result.insert(std::to_string(c.r) + ' ' + std::to_string(c.g) + ' ' + std::to_string(c.b));
  return result;
}

TEST(Markers, everything_is_in_the_frame_of_the_plan_and_replaces_what_was_drawn_before)
{
  std::set<std::string> names;
  for (const Marker& marker : markers(switching_trajectory()).markers)
  {
    EXPECT_EQ(marker.header.frame_id, "map");
    EXPECT_EQ(marker.id, 0);
    EXPECT_EQ(marker.pose.orientation.w, 1.0);
    EXPECT_TRUE(names.insert(marker.ns).second) << marker.ns << " is there twice";
  }
  EXPECT_EQ(names, (std::set<std::string>{"path", "footprints", "switches", "start", "goal", "failure"}));
}

TEST(Markers, each_mode_has_a_colour_of_its_own_in_path_and_footprints)
{
  const MarkerArray array = markers(switching_trajectory());
  EXPECT_EQ(colours(named(array, "path")).size(), 3u);
  EXPECT_EQ(colours(named(array, "footprints")), colours(named(array, "path")));
}

TEST(Markers, every_vertex_of_a_line_list_has_a_colour_and_a_partner)
{
  for (const Marker& marker : markers(switching_trajectory()).markers)
  {
    if (marker.type != Marker::LINE_LIST) continue;
    EXPECT_EQ(marker.points.size() % 2, 0u) << marker.ns;
    EXPECT_EQ(marker.points.size(), marker.colors.size()) << marker.ns;
  }
}

TEST(Markers, a_switch_is_marked_where_the_mode_changes)
{
  const Marker switches = named(markers(switching_trajectory()), "switches");
  ASSERT_EQ(switches.points.size(), 2u);
  EXPECT_EQ(switches.points[0].x, 2.0);
  EXPECT_EQ(switches.points[1].y, 1.0);
}

TEST(Markers, footprints_are_the_body_of_the_robot)
{
  const Robot robot;
  const Marker start = named(markers(switching_trajectory()), "start");
  double reach = 0.0;
  for (const auto& corner : start.points) reach = std::max(reach, std::hypot(corner.x, corner.y));
  EXPECT_DOUBLE_EQ(reach, std::hypot(robot.length / 2.0, robot.width / 2.0));
}

TEST(Markers, what_a_plan_does_not_have_is_removed_from_the_display)
{
  const MarkerArray array = markers({point(0, Mode::ackermann, 0, 0), point(1, Mode::ackermann, 1, 0)});
  EXPECT_EQ(named(array, "switches").action, Marker::DELETE);
  EXPECT_EQ(named(array, "path").action, Marker::ADD);
  EXPECT_EQ(expansion_marker({}, {}).action, Marker::DELETE);
}

TEST(Markers, a_failure_is_written_at_its_goal_until_the_next_plan)
{
  const Marker text = failure_marker({4, 1, 0}, PlanStatus::no_path, {});
  EXPECT_EQ(text.text, "no_path");
  EXPECT_EQ(text.pose.position.x, 4.0);
  const Marker removed = named(markers(switching_trajectory()), text.ns);
  EXPECT_EQ(removed.action, Marker::DELETE);
  EXPECT_EQ(removed.id, text.id);
}

TEST(Markers, every_expanded_node_is_a_point)
{
  PlanTrace trace;
  trace.expanded = {{1, 2, 0}, {3, 4, 0}};
  const Marker marker = expansion_marker(trace, {});
  ASSERT_EQ(marker.points.size(), 2u);
  EXPECT_EQ(marker.points[1].x, 3.0);
  EXPECT_EQ(marker.points[1].y, 4.0);
}

/// The half-planes of a rectangle.
Polytope region(double x_min, double y_min, double x_max, double y_max)
{
  return {{-1, 0, -x_min}, {0, -1, -y_min}, {1, 0, x_max}, {0, 1, y_max}};
}

/// Sum of the triangles' areas.
double area(const Marker& triangles)
{
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < triangles.points.size(); i += 3)
  {
    const auto &a = triangles.points[i], &b = triangles.points[i + 1], &c = triangles.points[i + 2];
    sum += std::abs((b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y)) / 2.0;
  }
  return sum;
}

TEST(Markers, corridors_are_translucent_and_cover_their_regions)
{
  const std::vector<Corridor> corridors = {
      {{{0.25, 0.0}, {region(0, 0, 1, 1), region(1, 0, 3, 2)}}, {{-0.25, 0.0}, {region(-1, 0, 0, 0.5)}}},
      {{{0.25, 0.0}, {region(3, 0, 4, 1)}}, {{-0.25, 0.0}, {region(0, 0, 0.5, 0.5)}}}};
  const Marker marker = corridor_marker(corridors, {0, 0, 0}, {});
  EXPECT_NEAR(area(marker), 6.75, 1e-6);
  EXPECT_EQ(marker.type, Marker::TRIANGLE_LIST);
  EXPECT_EQ(marker.points.size() % 3, 0u);
  EXPECT_GT(marker.color.a, 0.0);
  EXPECT_LT(marker.color.a, 0.2);
  for (const auto& corner : marker.points)
  {
    EXPECT_TRUE(corner.x >= -1.0 - 1e-6 && corner.x <= 4.0 + 1e-6) << corner.x;
    EXPECT_TRUE(corner.y >= -1e-6 && corner.y <= 2.0 + 1e-6) << corner.y;
  }
}

TEST(Markers, iterations_are_lines_the_later_the_more_opaque)
{
  const auto line = [](double y) {
    Trajectory points(3);
    for (std::size_t k = 0; k < 3; ++k) points[k].x = static_cast<double>(k), points[k].y = y;
    return points;
  };
  const Marker marker = iteration_marker({line(0.0), line(1.0)}, {});
  ASSERT_EQ(marker.points.size(), 8u);
  ASSERT_EQ(marker.colors.size(), 8u);
  EXPECT_EQ(marker.points[0].y, 0.0);
  EXPECT_EQ(marker.points[7].y, 1.0);
  EXPECT_LT(marker.colors[0].a, marker.colors[7].a);
  EXPECT_EQ(iteration_marker({}, {}).action, Marker::DELETE);
}

TEST(Markers, a_plan_without_corridors_removes_those_drawn_before)
{
  EXPECT_EQ(corridor_marker({}, {}, {}).action, Marker::DELETE);
}

}  // namespace
}  // namespace fourwis
