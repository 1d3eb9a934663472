#include "../support/rectangle.h"
#include "planned_drive.h"

namespace fourwis
{
namespace
{

const Pose kStart{3, 3, 0}, kEast{16, 3, 0}, kNorth{3, 16, M_PI / 2};

/// On a map that changes while the robot drives.
class Goals : public PlannedDrive
{
protected:
  void SetUp() override
  {
    wait_for_base();
    PlannerFixture::SetUp();
    cancel();
    wait_for_rest();
    map_message_ = walled_map(20.0, 0.05, ++stamp_);
    set_map(map_message_);
    place(kStart);
    ASSERT_TRUE(wait_until([this] { return starts_at(kStart); }));
    statuses_.clear();
    trajectories_.clear();
    tracking_.clear();
    truth_.clear();
  }

  /// The robot, wherever it was, against the map as it is now.
  void expect_free_of_the_map() const
  {
    const OccupancyGrid grid = to_grid(map_message_);
    const ExactRectangle body(grid, Robot());
    for (const auto& place : truth_.messages())
    {
      const Pose pose = to_pose(place->pose, "truth");
      ASSERT_FALSE(body.collides(pose)) << pose.x << ' ' << pose.y << ' ' << pose.theta;
    }
  }

  /// A wall from the southern edge up to y [m] becomes known.
  void build_wall(double x, double y)
  {
    occupy(x, 0.0, 0.2, y, map_message_);
    map_message_.header.stamp = ros::Time(++stamp_);
    set_map(map_message_);
  }

  static double stamp_;
  nav_msgs::OccupancyGrid map_message_;
};

double Goals::stamp_ = 0.0;

TEST_F(Goals, a_goal_is_driven_to)
{
  send_goal({6, 5, M_PI / 2});
  expect_arrival({6, 5, M_PI / 2});
}

TEST_F(Goals, a_new_goal_on_the_way_is_planned_from_where_the_robot_came_to_rest)
{
  drive_towards(kEast);
  send_goal(kNorth);
  expect_arrival(kNorth);
  const auto second = trajectories_.wait_for([](const ModeTrajectory& t) { return !t.points.empty(); });
  ASSERT_TRUE(second);
  EXPECT_GT(second->points.front().x, kStart.x);
  for (const auto& tracking : tracking_.messages())
  {
    const bool begins = tracking->trajectory == second->header.stamp && tracking->state == Tracking::ALIGNING;
    ASSERT_TRUE(!begins || tracking->speed < 0.02) << "it did not come to rest between the two";
  }
}

TEST_F(Goals, a_goal_within_a_wall_is_refused_and_the_drive_goes_on)
{
  drive_towards(kEast);
  const Pose misclick{19.9, 10.0, 0.0};
  send_goal(misclick);
  const auto refused = statuses_.wait_for([](const PlannerStatus& s) { return s.status == "goal_in_collision"; });
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->map_stamp, map_message_.header.stamp);
  EXPECT_NE(refused->message.find("the nearest free pose is"), std::string::npos) << refused->message;
  expect_arrival(kEast);
  EXPECT_TRUE(trajectories_.messages().empty()) << "nothing was sent but the first trajectory";
}

TEST_F(Goals, cancel_stops_it_on_the_way_and_the_next_goal_is_driven_to)
{
  drive_towards(kEast);
  EXPECT_TRUE(cancel().success);
  ASSERT_TRUE(wait_for_status("cancelled", kEast));
  wait_for_rest();
  EXPECT_LT(truth().x, kEast.x - 1.0);
  send_goal(kStart);
  expect_arrival(kStart);
}

TEST_F(Goals, of_two_goals_at_once_the_last_is_driven_to)
{
  send_goal({9, 3, 0});
  send_goal({3, 6, 0});
  expect_arrival({3, 6, 0});
}

TEST_F(Goals, goals_that_come_all_the_time_stop_it_and_the_last_is_driven_to)
{
  drive_towards(kEast);
  for (int i = 0; i < 30; ++i)
  {
    send_goal({kStart.x, 6.0 + 0.1 * i, 0.0});
    pass(0.1);
  }
  EXPECT_LT(tracking_.messages().back()->speed, 0.05);
  EXPECT_LT(truth().x, kStart.x + 3.0);
  expect_arrival({kStart.x, 6.0 + 0.1 * 29, 0.0});
}

TEST_F(Goals, a_wall_across_the_way_stops_it_in_time_and_is_driven_around)
{
  drive_towards(kEast);
  build_wall(6.5, 8.0);
  ASSERT_TRUE(wait_for_status("stopping", kEast));
  expect_arrival(kEast);
  expect_free_of_the_map();
}

TEST_F(Goals, where_a_wall_leaves_no_way_it_stops_before_it_and_says_so)
{
  drive_towards(kEast);
  build_wall(6.5, 20.0);
  ASSERT_TRUE(wait_for_status("goal_unreachable", kEast));
  wait_for_rest();
  expect_free_of_the_map();
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "test_driving_goals");
}
