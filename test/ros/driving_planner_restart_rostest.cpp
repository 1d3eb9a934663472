#include <memory>

#include "node_process.h"
#include "planned_drive.h"

namespace fourwis
{
namespace
{

const Pose kStart{3, 3, 0}, kEast{16, 3, 0}, kNorth{5, 6, M_PI / 2};

/// Planner and controller die and come up again. Nothing moves then before there is a new goal.
class Restarts : public PlannedDrive
{
protected:
  void SetUp() override
  {
    wait_for_base();
    start_controller();
    start_planner();
    wait_for_rest();
    place(kStart);
    ASSERT_TRUE(wait_until([this] { return starts_at(kStart); }));
    tracking_.clear();
    statuses_.clear();
    trajectories_.clear();
  }

  void start_controller() { controller_.emplace("mpc_controller_node", std::vector<std::string>()); }

  /// Returns when it has a map.
  void start_planner()
  {
    statuses_.clear();
    const std::vector<std::string> arguments{"__name:=move_base", "tracking:=mpc_controller/tracking"};
    planner_.emplace("global_planner_node", arguments);
    PlannerFixture::SetUp();
    const nav_msgs::OccupancyGrid map = walled_map(20.0, 0.05, ++stamp_);
    // Again and again: a planner that has died counts as a subscriber, too.
    ASSERT_TRUE(wait_until([&] {
      map_.publish(map);
      return plan(stamped({}), stamped({})).map_stamp == map.header.stamp;
    }));
  }

  /// From the place where something has just happened to it.
  void expect_stopped_soon(const Pose& place)
  {
    wait_for_rest();
    EXPECT_LT(distance(truth(), place), 1.0);
  }

  void expect_no_motion_before_the_next_goal()
  {
    const Pose rest = truth();
    pass(2.0);
    EXPECT_LT(distance(truth(), rest), 1e-4);
    send_goal(kNorth);
    expect_arrival(kNorth);
  }

  static double stamp_;
  std::optional<NodeProcess> controller_, planner_;
};

double Restarts::stamp_ = 0.0;

TEST_F(Restarts, a_robot_whose_planner_dies_stops)
{
  drive_towards(kEast);
  planner_->crash();
  expect_stopped_soon(truth());
  start_planner();
  expect_no_motion_before_the_next_goal();
}

TEST_F(Restarts, a_planner_that_finds_the_robot_driving_stops_it)
{
  ros::Publisher publisher = node_.advertise<ModeTrajectory>("trajectory", 10);
  ASSERT_TRUE(wait_until([&] { return publisher.getNumSubscribers() > 1; }));
  ModeTrajectory trajectory = plan(stamped({}, ""), stamped(kEast), {"ackermann"}).trajectory;
  planner_.reset();
  trajectory.header.stamp = ros::Time::now();
  publisher.publish(trajectory);
  wait_for_motion(trajectory.header.stamp);
  start_planner();
  ASSERT_TRUE(wait_for_tracking([](const Tracking& t) { return t.state == Tracking::IDLE; }));
  wait_for_rest();
  EXPECT_LT(truth().x, kEast.x - 1.0);
  expect_no_motion_before_the_next_goal();
}

TEST_F(Restarts, a_goal_fails_when_the_controller_is_restarted_on_the_way)
{
  drive_towards(kEast);
  controller_->crash();
  const Pose place = truth();
  start_controller();
  ASSERT_TRUE(wait_for_status("drive_failed", kEast));
  expect_stopped_soon(place);
  expect_no_motion_before_the_next_goal();
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "test_driving_planner_restart");
}
