#include <memory>

#include "../support/rectangle.h"
#include "fourwis_navigation/DrivePermit.h"
#include "node_process.h"
#include "planned_drive.h"

namespace fourwis
{
namespace
{

using fourwis_navigation::DrivePermit;

const Pose kStart{3, 3, 0}, kEast{16, 3, 0};

/// The planner is a process that the test may freeze, wholly or a thread of it.
class Permits : public PlannedDrive
{
protected:
  void SetUp() override
  {
    wait_for_base();
    planner_.emplace("global_planner_node",
                     std::vector<std::string>{"__name:=move_base", "tracking:=mpc_controller/tracking"});
    PlannerFixture::SetUp();
    map_message_ = walled_map(20.0, 0.05, ++stamp_);
    // Again and again: a planner that has died counts as a subscriber, too.
    ASSERT_TRUE(wait_until([&] {
      map_.publish(map_message_);
      return plan(stamped({}), stamped({})).map_stamp == map_message_.header.stamp;
    }));
    wait_for_rest();
    place(kStart);
    ASSERT_TRUE(wait_until([this] { return starts_at(kStart); }));
    forget_all();
  }

  void TearDown() override
  {
    planner_.reset();
    wait_for_rest();
  }

  void forget_all()
  {
    statuses_.clear();
    trajectories_.clear();
    tracking_.clear();
    truth_.clear();
    permits_.clear();
  }

  /// Returns when the robot is at full speed on its way.
  void drive_at_full_speed()
  {
    send_goal(kEast);
    ASSERT_TRUE(wait_for_tracking([](const Tracking& t) { return t.state == Tracking::DRIVING && t.speed > 0.98; }));
  }

  /// A wall across the hall becomes known; without waiting for the planner.
  void build_wall(double x)
  {
    occupy(x, 0.0, 0.2, 20.0, map_message_);
    map_message_.header.stamp = ros::Time(++stamp_);
    map_.publish(map_message_);
  }

  void expect_free_of_the_map() const
  {
    const OccupancyGrid grid = to_grid(map_message_);
    const ExactRectangle body(grid, Robot());
    for (const auto& place : truth_.messages())
      ASSERT_FALSE(body.collides(to_pose(place->pose, "truth"))) << place->pose.position.x;
  }

  /// Where the robot was when the controller told the stamp that the last permit echoes: from then on it is bounded.
  Pose place_of_last_permit() const
  {
    const auto permits = permits_.messages();
    const auto places = truth_.messages();
    if (permits.empty() || places.empty()) return {};
    const auto since = std::find_if(places.begin(), places.end(),
                                    [&](const auto& place) { return place->header.stamp >= permits.back()->heard; });
    return to_pose((since == places.end() ? places.back() : *since)->pose, "truth");
  }

  bool controller_says(const std::string& part) const
  {
    const auto messages = tracking_.messages();
    return std::any_of(messages.begin(), messages.end(),
                       [&](const auto& t) { return t->message.find(part) != std::string::npos; });
  }

  static double stamp_;
  std::optional<NodeProcess> planner_;
  nav_msgs::OccupancyGrid map_message_;
  Inbox<DrivePermit> permits_{"drive_permit"};
};

double Permits::stamp_ = 0.0;

/// v (permit_timeout, latency, lag, a step) + v^2 / 2a + 5 cm.
constexpr double kLongestStop = 1.0 * (0.3 + 0.02 + 0.03 + 0.02) + 0.1 + 0.05;

TEST_F(Permits, come_often_and_echo_the_controllers_clock)
{
  drive_at_full_speed();
  pass(1.0);
  const auto messages = permits_.messages();
  ASSERT_GT(messages.size(), 10u);
  const auto trajectory = trajectories_.messages().back();
  for (std::size_t i = 1; i < messages.size(); ++i)
  {
    EXPECT_EQ(messages[i]->trajectory, trajectory->header.stamp);
    EXPECT_EQ(messages[i]->map_stamp, map_message_.header.stamp);
    EXPECT_GT(messages[i]->heard, messages[i - 1]->heard);
    EXPECT_TRUE(std::isinf(messages[i]->free_until));
  }
}

TEST_F(Permits, of_a_planner_that_is_frozen_end_and_the_robot_rests_before_a_wall)
{
  drive_at_full_speed();
  planner_->freeze();
  const Pose there = truth();
  build_wall(there.x + 2.0);
  wait_for_rest();
  EXPECT_LT(distance(truth(), place_of_last_permit()), kLongestStop);
  EXPECT_TRUE(controller_says("permission to drive is"));
  expect_free_of_the_map();
  planner_->thaw();  // It sees the wall and says so.
  ASSERT_TRUE(wait_for_status("goal_unreachable", kEast));
  wait_for_rest();
  expect_free_of_the_map();
}

TEST_F(Permits, of_a_planner_that_is_killed_end)
{
  drive_at_full_speed();
  planner_->crash();
  wait_for_rest();
  EXPECT_LT(distance(truth(), place_of_last_permit()), kLongestStop);
  planner_->exit_status();
}

TEST_F(Permits, that_come_again_let_it_go_on_with_the_same_trajectory)
{
  drive_at_full_speed();
  planner_->freeze();
  wait_for_rest();
  planner_->thaw();
  expect_arrival(kEast);
  EXPECT_EQ(trajectories_.messages().size(), 1u);
}

TEST_F(Permits, for_another_trajectory_change_nothing)
{
  ros::Publisher other = node_.advertise<DrivePermit>("drive_permit", 10);
  drive_at_full_speed();
  tracking_.clear();
  DrivePermit permit;
  permit.trajectory = ros::Time(12345.0);
  for (int k = 0; k < 50; ++k)
  {
    permit.heard = ros::Time::now();
    other.publish(permit);
    pass(0.02);
  }
  for (const auto& tracking : tracking_.messages()) ASSERT_GT(tracking->speed, 0.9);
}

/// Whichever thread it is: the robot does not drive into what the planner does not see.
TEST_F(Permits, no_thread_of_the_planner_may_hang_and_leave_the_robot_blind)
{
  // A node's threads come and go with its connections: those that have settled.
  drive_at_full_speed();
  const std::vector<pid_t> threads = planner_->threads();
  cancel();
  wait_for_rest();
  int stopped = 0;
  for (const pid_t thread : threads)
  {
    SCOPED_TRACE("thread " + std::to_string(thread));
    map_message_ = walled_map(20.0, 0.05, ++stamp_);
    set_map(map_message_);
    place(kStart);
    ASSERT_TRUE(wait_until([this] { return starts_at(kStart); }));
    forget_all();
    drive_at_full_speed();
    if (!NodeProcess::freeze_thread(thread)) continue;
    build_wall(truth().x + 2.5);
    // The robot would be there by then.
    pass(4.0);
    expect_free_of_the_map();
    EXPECT_LT(tracking_.messages().back()->speed, 0.05);
    ++stopped;
    NodeProcess::thaw_thread(thread);
    cancel();
    wait_for_rest();
  }
  EXPECT_GE(stopped, 4);
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "test_permit");
}
