#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "../support/random.h"
#include "../support/sentences.h"
#include "fourwis_navigation/model/fingerprint.h"
#include "ros/conversions.h"

namespace fourwis
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

geometry_msgs::Quaternion quaternion(double x, double y, double z, double w)
{
  geometry_msgs::Quaternion q;
  q.x = x;
  q.y = y;
  q.z = z;
  q.w = w;
  return q;
}

geometry_msgs::Pose with_orientation(const geometry_msgs::Quaternion& q)
{
  geometry_msgs::Pose pose;
  pose.orientation = q;
  return pose;
}

nav_msgs::OccupancyGrid small_map()
{
  nav_msgs::OccupancyGrid map;
  map.header.frame_id = "map";
  map.info.width = 3;
  map.info.height = 2;
  map.info.resolution = 0.5f;
  map.info.origin.orientation.w = 1.0;
  map.data = {0, 100, -1, 1, 2, 3};
  return map;
}

map_msgs::OccupancyGridUpdate update(int x, int y, unsigned width, unsigned height, std::size_t cells)
{
  map_msgs::OccupancyGridUpdate update;
  update.x = x;
  update.y = y;
  update.width = width;
  update.height = height;
  update.data.assign(cells, 77);
  return update;
}

std::string map_refusal(const std::function<void(nav_msgs::OccupancyGrid&)>& spoil)
{
  nav_msgs::OccupancyGrid map = small_map();
  spoil(map);
  return error_of<ConversionError>([&map] { to_grid(map); });
}

std::string pose_refusal(const geometry_msgs::Pose& pose)
{
  return error_of<ConversionError>([&pose] { to_pose(pose, "goal"); });
}

TEST(Conversions, a_pose_survives_the_way_there_and_back)
{
  Random random(7);
  for (int i = 0; i < 1000; ++i)
  {
    const Pose pose = random.pose(100.0);
    SCOPED_TRACE("pose " + std::to_string(i) + " of seed 7");
    const Pose back = to_pose(to_message(pose), "pose");
    EXPECT_EQ(back.x, pose.x);
    EXPECT_EQ(back.y, pose.y);
    EXPECT_NEAR(wrap_angle(back.theta - pose.theta), 0.0, 1e-12);
  }
}

TEST(Conversions, both_signs_of_a_quaternion_are_one_heading)
{
  const Pose a = to_pose(with_orientation(quaternion(0, 0, 0.6, 0.8)), "pose");
  const Pose b = to_pose(with_orientation(quaternion(0, 0, -0.6, -0.8)), "pose");
  EXPECT_DOUBLE_EQ(a.theta, b.theta);
}

TEST(Conversions, the_height_of_a_pose_is_not_looked_at)
{
  geometry_msgs::Pose pose = to_message(Pose{1.0, 2.0, 0.5});
  pose.position.z = 3.0;
  EXPECT_EQ(pose_refusal(pose), "");
}

TEST(Conversions, a_quaternion_that_is_not_normalised_is_refused_by_name)
{
  for (const auto& q : {quaternion(0, 0, 0, 0), quaternion(0, 0, 0, 1.01), quaternion(0, 0, 0.5, 0.5),
                        quaternion(0, 0, kNaN, 1), quaternion(0, 0, 0, kInf)})
  {
    const std::string text = pose_refusal(with_orientation(q));
    EXPECT_TRUE(says(text, "goal: orientation"));
    EXPECT_TRUE(says(text, "norm"));
  }
}

TEST(Conversions, a_quaternion_with_the_rounding_of_a_text_file_is_accepted)
{
  EXPECT_EQ(pose_refusal(with_orientation(quaternion(0, 0, 0.707, 0.707))), "");
}

TEST(Conversions, a_pose_tilted_out_of_the_plane_is_refused_by_name)
{
  const double half = kMaxTilt / 2.0;
  const auto rolled = [](double h) { return with_orientation(quaternion(std::sin(h), 0, 0, std::cos(h))); };
  const auto pitched = [](double h) { return with_orientation(quaternion(0, std::sin(h), 0, std::cos(h))); };
  EXPECT_EQ(pose_refusal(rolled(0.99 * half)), "");
  EXPECT_EQ(pose_refusal(pitched(-0.99 * half)), "");
  for (const auto& pose : {rolled(1.01 * half), pitched(-1.01 * half), rolled(M_PI_2)})
    EXPECT_TRUE(says(pose_refusal(pose), "goal: orientation is tilted"));
}

TEST(Conversions, a_position_that_is_not_finite_is_refused_by_name)
{
  for (double bad : {kNaN, kInf, -kInf})
  {
    geometry_msgs::Pose pose = to_message(Pose{});
    pose.position.y = bad;
    EXPECT_TRUE(says(pose_refusal(pose), "goal: position"));
  }
}

TEST(Conversions, a_map_survives_the_way_there_and_back)
{
  nav_msgs::OccupancyGrid map = small_map();
  map.info.origin = to_message(Pose{-3.0, 4.0, 0.3});
  const OccupancyGrid grid = to_grid(map);
  EXPECT_EQ(grid.width, 3);
  EXPECT_EQ(grid.height, 2);
  EXPECT_DOUBLE_EQ(grid.resolution, 0.5);
  EXPECT_EQ(grid.at(1, 0), 100);
  EXPECT_EQ(grid.at(2, 0), -1);
  EXPECT_EQ(grid.at(0, 1), 1);
  EXPECT_NEAR(grid.origin.theta, 0.3, 1e-12);

  const nav_msgs::OccupancyGrid back = to_message(grid, map.header);
  EXPECT_EQ(back.data, map.data);
  EXPECT_EQ(back.header.frame_id, "map");
  EXPECT_EQ(back.info.width, map.info.width);
  EXPECT_EQ(back.info.height, map.info.height);
  EXPECT_EQ(back.info.resolution, map.info.resolution);
  EXPECT_NEAR(back.info.origin.orientation.z, map.info.origin.orientation.z, 1e-12);
}

TEST(Conversions, a_map_whose_origin_has_no_orientation_is_not_turned)
{
  nav_msgs::OccupancyGrid map = small_map();
  map.info.origin = geometry_msgs::Pose();
  map.info.origin.position.x = -3.0;
  const Pose origin = to_grid(map).origin;
  EXPECT_EQ(origin.x, -3.0);
  EXPECT_EQ(origin.theta, 0.0);
}

TEST(Conversions, an_unusable_map_is_refused_by_the_field_that_is_wrong)
{
  using Map = nav_msgs::OccupancyGrid;
  EXPECT_EQ(map_refusal([](Map&) {}), "");
  EXPECT_TRUE(
      says(map_refusal([](Map& m) { m.data.pop_back(); }), "data holds 5 cells, expected width x height = 3 x 2"));
  EXPECT_TRUE(says(map_refusal([](Map& m) { m.data.push_back(0); }), "data holds 7 cells"));
  EXPECT_TRUE(says(map_refusal([](Map& m) { m.info.width = 0; }), "size is 0 x 2"));
  EXPECT_TRUE(says(map_refusal([](Map& m) { m = Map(); }), "size is 0 x 0"));
  // 2^32 - 1 squared does not fit into 64 bits when added to, and must not wrap around to the size of the data.
  EXPECT_TRUE(says(map_refusal([](Map& m) { m.info.width = m.info.height = 0xffffffffu; }), "data holds 6 cells"));
  for (float bad : {0.0f, -0.05f, float(kNaN), float(kInf)})
    EXPECT_TRUE(says(map_refusal([bad](Map& m) { m.info.resolution = bad; }), "resolution"));
  EXPECT_TRUE(says(map_refusal([](Map& m) { m.info.origin.orientation.w = 0.5; }), "map: origin: orientation"));
  EXPECT_TRUE(says(map_refusal([](Map& m) { m.info.origin.orientation.z = kNaN; }), "map: origin: orientation"));
  EXPECT_TRUE(says(map_refusal([](Map& m) { m.info.origin.position.x = kNaN; }), "map: origin: position"));
}

TEST(Conversions, an_update_overwrites_its_rectangle_and_nothing_else)
{
  for (int x = 0; x <= 3; ++x)
    for (int y = 0; y <= 2; ++y)
      for (int width = 0; x + width <= 3; ++width)
        for (int height = 0; y + height <= 2; ++height)
        {
          OccupancyGrid grid = to_grid(small_map());
          const OccupancyGrid before = grid;
          apply_update(update(x, y, unsigned(width), unsigned(height), std::size_t(width * height)), grid);
          for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 2; ++row)
            {
              const bool inside = column >= x && column < x + width && row >= y && row < y + height;
              EXPECT_EQ(grid.at(column, row), inside ? 77 : before.at(column, row))
                  << "cell " << column << ", " << row << " after " << width << " x " << height << " at " << x << ", "
                  << y;
            }
        }
}

TEST(Conversions, an_update_that_does_not_fit_is_refused_and_changes_nothing)
{
  OccupancyGrid grid = to_grid(small_map());
  const OccupancyGrid before = grid;
  for (const auto& bad : {update(-1, 0, 1, 1, 1), update(0, -1, 1, 1, 1), update(3, 0, 1, 1, 1), update(0, 1, 1, 2, 2),
                          update(0, 0, 0xffffffffu, 1, 1), update(2147483647, 0, 1, 1, 1)})
    EXPECT_TRUE(says(error_of<ConversionError>([&] { apply_update(bad, grid); }), "do not lie in the map of 3 x 2"));
  EXPECT_TRUE(
      says(error_of<ConversionError>([&] { apply_update(update(0, 0, 2, 2, 3), grid); }), "data holds 3 cells"));
  EXPECT_EQ(grid.data, before.data);
}

TEST(Conversions, modes_are_those_named_and_all_when_none_is)
{
  EXPECT_TRUE(to_modes({}) == (ModeSet{Mode::ackermann, Mode::lateral, Mode::parallel}));
  EXPECT_TRUE(to_modes({"lateral"}) == ModeSet{Mode::lateral});
  for (const char* bad : {"sideways", "spin", "none", "", "Lateral"})
  {
    const std::string text = error_of<ConversionError>([bad] { to_modes({"lateral", bad}); });
    EXPECT_TRUE(says(text, "modes: '" + std::string(bad) + "'"));
  }
}

TEST(Conversions, a_trajectory_message_carries_its_robot_and_every_field_of_every_point)
{
  Robot robot;
  robot.length = 1.5;
  const Trajectory trajectory = {{0.0, Mode::ackermann, 1, 2, 3, 4, 5, 6, 7},
                                 {0.5, Mode::lateral, -1, -2, -3, -4, -5, -6, -7}};
  std_msgs::Header header;
  header.frame_id = "map";
  const fourwis_navigation::ModeTrajectory message = to_message(robot, trajectory, header);
  EXPECT_EQ(message.header.frame_id, "map");
  EXPECT_EQ(message.fingerprint, fingerprint(robot));
  ASSERT_EQ(message.points.size(), 2u);
  const fourwis_navigation::TrajectoryPoint& last = message.points[1];
  EXPECT_EQ(message.points[0].mode, fourwis_navigation::TrajectoryPoint::ACKERMANN);
  EXPECT_EQ(last.mode, fourwis_navigation::TrajectoryPoint::LATERAL);
  EXPECT_EQ(last.t, 0.5);
  EXPECT_EQ(last.x, -1);
  EXPECT_EQ(last.y, -2);
  EXPECT_EQ(last.theta, -3);
  EXPECT_EQ(last.v, -4);
  EXPECT_EQ(last.phi, -5);
  EXPECT_EQ(last.a, -6);
  EXPECT_EQ(last.omega, -7);
}

TEST(Conversions, the_front_ends_path_is_sampled_densely_from_start_to_goal)
{
  const Robot robot;
  Path path;
  path.pieces = {{Mode::ackermann, {0, 0, 0}, 0.0, 1.02}, {Mode::lateral, {1.02, 0, 0}, 0.0, -0.5}};
  path.goal = {1.02, -0.5, 0};
  const nav_msgs::Path message = to_path_message(robot, path, {}, 0.05);
  ASSERT_GE(message.poses.size(), 31u);
  for (std::size_t i = 1; i < message.poses.size(); ++i)
  {
    const auto &a = message.poses[i - 1].pose.position, &b = message.poses[i].pose.position;
    EXPECT_LE(std::hypot(b.x - a.x, b.y - a.y), 0.05 + 1e-9) << "pose " << i;
  }
  EXPECT_EQ(message.poses.front().pose.position.x, 0.0);
  EXPECT_EQ(message.poses.back().pose.position.y, -0.5);
  EXPECT_TRUE(to_path_message(robot, Path{}, {}).poses.empty());
}

TEST(Conversions, each_metric_is_in_the_field_of_its_name)
{
  PlanMetrics metrics;
  metrics.safe = true;
  metrics.length = 1.0;
  metrics.arrival_time = 2.0;
  metrics.mean_curvature = 3.0;
  metrics.max_curvature = 4.0;
  metrics.terminal_position_error = 5.0;
  metrics.terminal_yaw_error = 6.0;
  metrics.standard_mode_rate = 7.0;
  metrics.total_ms = 8.0;
  metrics.map_ms = 9.0;
  metrics.frontend_ms = 10.0;
  metrics.backend_ms = 11.0;
  metrics.verify_ms = 12.0;
  metrics.expansions = 13;
  metrics.switches = 14;
  metrics.outer_iterations = 15;
  metrics.ipopt_iterations = 16;
  metrics.min_clearance = 17.0;
  const fourwis_navigation::PlanMetrics message = to_message(metrics);
  EXPECT_TRUE(message.safe);
  EXPECT_EQ(message.length, 1.0);
  EXPECT_EQ(message.arrival_time, 2.0);
  EXPECT_EQ(message.mean_curvature, 3.0);
  EXPECT_EQ(message.max_curvature, 4.0);
  EXPECT_EQ(message.terminal_position_error, 5.0);
  EXPECT_EQ(message.terminal_yaw_error, 6.0);
  EXPECT_EQ(message.standard_mode_rate, 7.0);
  EXPECT_EQ(message.total_ms, 8.0);
  EXPECT_EQ(message.map_ms, 9.0);
  EXPECT_EQ(message.frontend_ms, 10.0);
  EXPECT_EQ(message.backend_ms, 11.0);
  EXPECT_EQ(message.verify_ms, 12.0);
  EXPECT_EQ(message.expansions, 13);
  EXPECT_EQ(message.switches, 14);
  EXPECT_EQ(message.outer_iterations, 15);
  EXPECT_EQ(message.ipopt_iterations, 16);
  EXPECT_EQ(message.min_clearance, 17.0);
}

}  // namespace
}  // namespace fourwis
