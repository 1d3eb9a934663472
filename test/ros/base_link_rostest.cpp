#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <visualization_msgs/MarkerArray.h>

#include "../support/exact_polygon.h"
#include "fourwis_navigation/parameters/parameters.h"
#include "planned_drive.h"

namespace fourwis
{
namespace
{

const Pose kStart{3, 3, 0.3}, kGoal{7, 6, 1.9};

/// The robot whose base_link is at its rear axle.
class RearAxle : public PlannedDrive
{
protected:
  void SetUp() override
  {
    wait_for_base();
    PlannerFixture::SetUp();
    map_ = walled_map(12.0, 0.05, ++stamp_);
    occupy(4.5, 3.6, 0.8, 0.8, map_);
    set_map(map_);
    place(kStart);
    ASSERT_TRUE(wait_until([this] { return starts_at(kStart); }));
    for (Inbox<nav_msgs::Path>* paths : {&plans_, &frontend_plans_}) paths->clear();
    statuses_.clear();
    trajectories_.clear();
    odometry_.clear();
    truth_.clear();
  }

  static double stamp_;
  const Robot robot_ = read_robot_file(FOURWIS_SOURCE_DIR "/test/ros/rear_axle_robot.yaml");
  nav_msgs::OccupancyGrid map_;
  Inbox<nav_msgs::Odometry> odometry_{"odom"};
  Inbox<nav_msgs::Path> plans_{"move_base/plan"}, frontend_plans_{"move_base/frontend_plan"};
};

double RearAxle::stamp_ = 0.0;

TEST_F(RearAxle, is_driven_from_pose_to_pose_and_its_body_touches_nothing)
{
  send_goal(kGoal);
  expect_arrival(kGoal);
  const OccupancyGrid grid = to_grid(map_);
  const ExactPolygon body(grid, robot_);
  double moved = 0.0;
  Pose before = kStart;
  for (const auto& place : truth_.messages())
  {
    const Pose pose = to_pose(place->pose, "truth");
    ASSERT_FALSE(body.collides(pose)) << text(pose);
    moved += distance(before, pose);
    before = pose;
  }
  EXPECT_GT(moved, 4.0);
}

TEST_F(RearAxle, is_what_trajectory_and_paths_begin_and_end_with)
{
  send_goal(kGoal);
  const auto trajectory = trajectories_.wait_for([](const ModeTrajectory& t) { return !t.points.empty(); });
  ASSERT_TRUE(trajectory);
  const auto& points = trajectory->points;
  EXPECT_LT(std::hypot(points.front().x - kStart.x, points.front().y - kStart.y), 2e-3);
  EXPECT_LT(std::hypot(points.back().x - kGoal.x, points.back().y - kGoal.y), 1e-3);
  for (Inbox<nav_msgs::Path>* paths : {&plans_, &frontend_plans_})
  {
    const auto path = paths->wait_for([](const nav_msgs::Path& p) { return !p.poses.empty(); });
    ASSERT_TRUE(path);
    EXPECT_LT(distance(to_pose(path->poses.front().pose, "first"), kStart), 2e-3);
    EXPECT_LT(distance(to_pose(path->poses.back().pose, "last"), kGoal), 1e-3);
  }
  expect_arrival(kGoal);
}

/// The axle moves as its odometry's twist says, also sideways while the robot turns.
TEST_F(RearAxle, is_whose_velocity_odometry_tells)
{
  Inbox<geometry_msgs::Twist> commands("cmd_vel");
  send_goal(kGoal);
  expect_arrival(kGoal);
  const auto messages = odometry_.messages();
  double turned = 0.0;
  for (std::size_t i = 1; i < messages.size(); ++i)
  {
    const nav_msgs::Odometry &before = *messages[i - 1], &after = *messages[i];
    ASSERT_EQ(after.child_frame_id, "base_link");
    const double elapsed = (after.header.stamp - before.header.stamp).toSec();
    const Pose step = relative_to(to_pose(before.pose.pose, "before"), to_pose(after.pose.pose, "after"));
    const geometry_msgs::Twist &u = before.twist.twist, &v = after.twist.twist;
    // The mean of the twists at both ends, on an arc.
    ASSERT_NEAR(step.x / elapsed, (u.linear.x + v.linear.x) / 2.0, 0.02);
    ASSERT_NEAR(step.y / elapsed, (u.linear.y + v.linear.y) / 2.0, 0.03);
    turned = std::max(turned, std::abs(v.angular.z));
  }
  EXPECT_GT(turned, 0.3) << "there was a turn to tell base_link from the centre by";
  bool commanded = false;
  for (const auto& twist : commands.messages())
    if (std::abs(twist->angular.z) > 0.3 && std::abs(twist->linear.x) > 0.3 && std::abs(twist->linear.y) < 0.4)
      commanded = true;
  EXPECT_TRUE(commanded);
}

TEST_F(RearAxle, has_its_footprint_drawn_around_it)
{
  Inbox<visualization_msgs::MarkerArray> markers("move_base/markers");
  send_goal(kGoal);
  const auto array = markers.wait_for([](const visualization_msgs::MarkerArray& a) {
    return std::any_of(a.markers.begin(), a.markers.end(),
                       [](const auto& m) { return m.ns == "goal" && !m.points.empty(); });
  });
  ASSERT_TRUE(array);
  for (const visualization_msgs::Marker& marker : array->markers)
  {
    if (marker.ns != "goal") continue;
    for (const Point2& corner : robot_.footprint)
    {
      const Pose expected = compose(kGoal, {corner.x, corner.y, 0.0});
      EXPECT_TRUE(std::any_of(marker.points.begin(), marker.points.end(), [&](const geometry_msgs::Point& p) {
        return std::hypot(p.x - expected.x, p.y - expected.y) < 1e-6;
      })) << text(expected);
    }
  }
  expect_arrival(kGoal);
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "test_base_link");
}
