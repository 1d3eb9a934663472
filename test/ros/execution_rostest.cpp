#include <algorithm>
#include <map>
#include <optional>

#include "fake_controller.h"
#include "planner_fixture.h"

namespace fourwis
{
namespace
{

const Pose kStart{2, 2, 0}, kEast{8, 2, 0}, kNorth{2, 8, 0};
constexpr double kStartDelay = 0.2, kStopDelay = 0.05;  // config/global_planner.yaml
constexpr double kHold = 2.0;                           // where drives are held up, about 2 m from the start [s]

std::optional<FakeController> controller;

class Execution : public PlannerFixture
{
protected:
  void SetUp() override
  {
    PlannerFixture::SetUp();
    controller->reset(kStart);
    cancel();
    set_map(walled_map(10.0, 0.1, ++stamp_));
    ASSERT_TRUE(wait_until([this] { return starts_at(kStart) && controller->rests(); }));
    ASSERT_TRUE(wait_until([this] { return current_goals_.connected() && feedback_.connected(); }));
    statuses_.clear();
    trajectories_.clear();
    current_goals_.clear();
    feedback_.clear();
  }

  void TearDown() override { EXPECT_FALSE(controller->surprised()) << "a trajectory came while the robot drove"; }

  void send_action(const Pose& goal)
  {
    move_base_msgs::MoveBaseGoal message;
    message.target_pose = stamped(goal);
    action_.sendGoal(message);
  }

  /// Returns when the robot is held up on its way to the goal.
  void drive_towards(const Pose& goal)
  {
    controller->hold_at(kHold);
    send_action(goal);
    ASSERT_TRUE(wait_for_status("driving", goal));
    ASSERT_TRUE(wait_until([] { return distance(controller->pose(), kStart) > 1.0; }));
  }

  void expect_end(const std::string& state, const std::string& part = "")
  {
    ASSERT_TRUE(action_.waitForResult(ros::Duration(10.0 * kPatience)));
    EXPECT_EQ(action_.getState().toString(), state);
    EXPECT_NE(action_.getState().getText().find(part), std::string::npos)
        << "'" << action_.getState().getText() << "' lacks '" << part << "'";
  }

  Inbox<ModeTrajectory>::Pointer wait_for_stop()
  {
    return trajectories_.wait_for([](const ModeTrajectory& t) { return t.points.empty(); });
  }

  /// 'S' for a stop, 'T' for a trajectory, in the order in which they came.
  std::string sent() const
  {
    std::string kinds;
    for (const auto& trajectory : trajectories_.messages()) kinds += trajectory->points.empty() ? 'S' : 'T';
    return kinds;
  }

  /// The statuses of the goal, in order.
  std::string statuses_of(const Pose& goal) const
  {
    std::string names;
    for (const auto& status : statuses_.messages())
      if (distance(to_pose(status->goal.pose, "goal"), goal) < 1e-9)
        names += (names.empty() ? "" : " ") + status->status;
    return names;
  }

  void update_map(double x, double y, double width, double height)
  {
    update_map(x, y, width, height, ros::Time(++stamp_));
  }
  void update_map(double x, double y, double width, double height, const ros::Time& stamp)
  {
    map_msgs::OccupancyGridUpdate update;
    update.header.frame_id = "map";
    update.header.stamp = stamp;
    const auto cells = [](double length) { return static_cast<int>(std::lround(length / 0.1)); };
    update.x = cells(x);
    update.y = cells(y);
    update.width = static_cast<std::uint32_t>(cells(width));
    update.height = static_cast<std::uint32_t>(cells(height));
    update.data.assign(update.width * update.height, 100);
    update_.publish(update);
    wait_for_map(update.header.stamp);
  }

  /// The stamp of the stop that comes because of a wall across the way in a map of this stamp.
  ros::Time stop_for_wall(const ros::Time& stamp)
  {
    trajectories_.clear();
    update_map(6.0, 0.1, 0.2, 9.8, stamp);
    const auto stop = wait_for_stop();
    return stop ? stop->header.stamp : ros::Time();
  }

  static double stamp_;
  Inbox<geometry_msgs::PoseStamped> current_goals_{"move_base/current_goal"};
  Inbox<move_base_msgs::MoveBaseActionFeedback> feedback_{"move_base/feedback"};
};

double Execution::stamp_ = 0.0;

TEST_F(Execution, a_goal_is_reached_when_the_controller_says_so)
{
  drive_towards(kEast);
  EXPECT_EQ(action_.getState().toString(), "ACTIVE");
  EXPECT_TRUE(feedback_.wait_for([](const move_base_msgs::MoveBaseActionFeedback& f) {
    return f.feedback.base_position.pose.position.x > kStart.x + 1.0;
  }));
  controller->release();
  expect_end("SUCCEEDED", "arrived in ");
  EXPECT_LT(distance(controller->pose(), kEast), 1e-3);
  ASSERT_TRUE(wait_for_status("arrived", kEast));
  EXPECT_EQ(statuses_of(kEast), "planning succeeded driving arrived");
  EXPECT_EQ(sent(), "T");
}

TEST_F(Execution, a_plan_starts_from_where_the_robot_was_at_the_goals_stamp_and_begins_soon_after)
{
  geometry_msgs::PoseStamped goal = stamped(kEast);
  goal.header.stamp = ros::Time::now();
  send_goal(goal);
  const auto first = trajectories_.wait_for_any();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->header.stamp, goal.header.stamp + ros::Duration(kStartDelay));
  const auto current = current_goals_.wait_for_any();
  ASSERT_TRUE(current);
  EXPECT_EQ(current->header.stamp, goal.header.stamp);
  EXPECT_EQ(current->pose, goal.pose);
  ASSERT_TRUE(wait_for_status("arrived", kEast));

  // A goal without a stamp, or with one from another clock, counts from when it comes.
  for (const double stamp : {0.0, 1e6})
  {
    current_goals_.clear();
    goal.header.stamp = ros::Time(stamp);
    const ros::Time before = ros::Time::now();
    send_goal(goal);
    const auto now = current_goals_.wait_for_any();
    ASSERT_TRUE(now);
    EXPECT_GE(now->header.stamp + ros::Duration(1.0), before);
    EXPECT_LT(now->header.stamp, ros::Time(1e6));
  }
}

TEST_F(Execution, a_new_goal_stops_the_robot_before_it_is_planned_for)
{
  drive_towards(kEast);
  controller->release();
  trajectories_.clear();
  send_goal(kNorth);
  expect_end("PREEMPTED");
  ASSERT_TRUE(wait_for_status("stopping", kNorth));
  ASSERT_TRUE(wait_for_status("arrived", kNorth));
  ASSERT_EQ(sent(), "ST");
  const auto messages = trajectories_.messages();
  EXPECT_GT(messages[1]->header.stamp, messages[0]->header.stamp + ros::Duration(0.2)) << "it takes time to stop";
  EXPECT_GT(messages[1]->points.front().x, kStart.x + 0.9);
  EXPECT_LT(distance(controller->pose(), kNorth), 1e-3);
  EXPECT_TRUE(wait_for_status("cancelled", kEast));
}

TEST_F(Execution, of_two_goals_at_once_the_last_wins)
{
  send_goal(kNorth);
  send_goal(kEast);
  ASSERT_TRUE(wait_for_status("arrived", kEast));
  drive_towards(kNorth);
  send_goal(kStart);
  send_goal({5, 5, 0});
  controller->release();
  ASSERT_TRUE(wait_for_status("arrived", {5, 5, 0}));
  EXPECT_LT(distance(controller->pose(), {5, 5, 0}), 1e-3);
}

TEST_F(Execution, a_goal_refused_for_its_form_does_not_disturb_the_drive)
{
  drive_towards(kEast);
  geometry_msgs::PoseStamped bad = stamped({4, 4, 0});
  bad.pose.orientation.w = 2.0;
  send_goal(bad);
  ASSERT_TRUE(wait_for_status("invalid_input", {4, 4, 0}));
  controller->release();
  expect_end("SUCCEEDED");
  EXPECT_EQ(sent(), "T");
}

TEST_F(Execution, what_services_answer_is_no_part_of_what_is_said_about_the_drive)
{
  const Pose into_the_wall{0, 5, 0};
  drive_towards(kEast);
  nav_msgs::GetPlan call;
  for (const char* frame : {"map", "moon"})
  {
    call.request.goal = stamped(into_the_wall, frame);
    ASSERT_TRUE(ros::service::call("/move_base/make_plan", call));
    EXPECT_TRUE(call.response.plan.poses.empty());
    EXPECT_FALSE(plan(stamped({}, ""), call.request.goal).success);
  }
  controller->release();
  expect_end("SUCCEEDED");
  ASSERT_TRUE(wait_for_status("arrived", kEast));
  EXPECT_EQ(statuses_of(kEast), "planning succeeded driving arrived");
  EXPECT_EQ(statuses_of(into_the_wall), "");
}

TEST_F(Execution, cancel_stops_the_robot_at_once)
{
  drive_towards(kEast);
  EXPECT_EQ(cancel().message, "cancelled");
  expect_end("PREEMPTED");
  ASSERT_TRUE(wait_for_stop());
  EXPECT_TRUE(wait_for_status("cancelled", kEast));
  controller->release();
  ASSERT_TRUE(wait_until([] { return controller->rests(); }));
  send_goal(kNorth);
  ASSERT_TRUE(wait_for_status("arrived", kNorth));
  EXPECT_EQ(sent(), "TST");
}

TEST_F(Execution, the_client_of_the_action_stops_the_robot_too)
{
  drive_towards(kEast);
  action_.cancelGoal();
  expect_end("PREEMPTED");
  EXPECT_TRUE(wait_for_stop());
}

TEST_F(Execution, what_the_controller_gives_up_is_planned_anew_and_in_the_end_fails_with_its_reason)
{
  controller->fail_at(1.0);
  send_action(kEast);
  expect_end("ABORTED", "off the path by 0.3 m");
  ASSERT_TRUE(wait_for_status("drive_failed", kEast));
  EXPECT_EQ(statuses_of(kEast), "planning succeeded driving planning succeeded driving drive_failed");
  ASSERT_TRUE(wait_for_stop());
  ASSERT_EQ(sent(), "TTS");  // replan_attempts is 1
  const auto messages = trajectories_.messages();
  EXPECT_GT(messages[1]->points.front().x, messages[0]->points.front().x + 0.3) << "not from where the robot was";
}

TEST_F(Execution, where_the_base_does_not_let_itself_be_driven_the_goal_fails_at_once)
{
  controller->disable_base_at(1.0);
  send_action(kEast);
  expect_end("ABORTED", "off the path by 0.3 m");
  ASSERT_TRUE(wait_for_status("drive_failed", kEast));
  EXPECT_EQ(statuses_of(kEast), "planning succeeded driving drive_failed");
}

TEST_F(Execution, a_base_that_was_disabled_while_the_robot_stopped_drives_to_a_new_goal_only)
{
  drive_towards(kEast);
  controller->disable_base_while_stopping();
  trajectories_.clear();
  send_action(kNorth);
  expect_end("ABORTED", "the base was not enabled");
  EXPECT_TRUE(wait_for_status("drive_failed", kNorth));
  send_action(kStart);
  expect_end("SUCCEEDED");
  const std::string kinds = sent();
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), 'T'), 1) << kinds;
}

TEST_F(Execution, a_refused_trajectory_of_another_node_does_not_disturb_the_drive)
{
  drive_towards(kEast);
  controller->refuse(ros::Time(1.0));
  controller->release();
  expect_end("SUCCEEDED");
  EXPECT_EQ(sent(), "T");
}

TEST_F(Execution, what_blocks_the_way_stops_the_robot_and_is_planned_around)
{
  drive_towards(kEast);
  trajectories_.clear();
  update_map(6.0, 1.0, 0.2, 2.0);
  const auto stopping = wait_for_status("stopping", kEast);
  ASSERT_TRUE(stopping);
  EXPECT_NE(stopping->message.find("the way is blocked: collision"), std::string::npos) << stopping->message;
  controller->release();
  expect_end("SUCCEEDED");
  EXPECT_EQ(sent(), "ST");
  EXPECT_LT(distance(controller->pose(), kEast), 1e-3);
}

TEST_F(Execution, a_stop_begins_soon_after_what_blocks_the_way_was_seen)
{
  drive_towards(kEast);
  const ros::Time seen = ros::Time::now();
  EXPECT_EQ(stop_for_wall(seen), seen + ros::Duration(kStopDelay));
}

TEST_F(Execution, a_stop_does_not_wait_for_a_map_that_is_stamped_ahead)
{
  drive_towards(kEast);
  const ros::Time ahead = ros::Time::now() + ros::Duration(0.45);
  const ros::Time stop = stop_for_wall(ahead);
  EXPECT_FALSE(stop.isZero());
  EXPECT_LT(stop, ahead);
}

TEST_F(Execution, obstacles_beside_or_behind_do_not_disturb_the_drive)
{
  drive_towards(kEast);
  update_map(5.0, 5.0, 1.0, 1.0);
  update_map(1.0, 1.0, 0.5, 2.0);  // over the start
  controller->release();
  expect_end("SUCCEEDED");
  EXPECT_EQ(sent(), "T");
}

TEST_F(Execution, where_there_is_no_way_left_the_robot_stops_and_the_goal_fails)
{
  drive_towards(kEast);
  update_map(6.0, 0.1, 0.2, 9.8);
  controller->release();
  expect_end("ABORTED", "no way is wide enough");
  EXPECT_TRUE(wait_for_status("goal_unreachable", kEast));
  EXPECT_EQ(sent(), "TS");
}

TEST_F(Execution, a_controller_that_was_restarted_gets_nothing_to_drive_until_the_next_goal)
{
  drive_towards(kEast);
  controller->restart();
  expect_end("ABORTED", "refused");
  ASSERT_TRUE(wait_for_stop());
  EXPECT_EQ(sent(), "TS");
  controller->release();
  send_goal(kNorth);
  EXPECT_TRUE(wait_for_status("arrived", kNorth));
}

TEST_F(Execution, a_silent_controller_is_told_to_stop_and_the_goal_fails)
{
  drive_towards(kEast);
  controller->fall_silent();
  expect_end("ABORTED", "the controller has not been heard on topic 'tracking' for 20 s");
  EXPECT_TRUE(wait_for_status("drive_failed", kEast));
  EXPECT_TRUE(wait_for_stop());
}

TEST_F(Execution, a_robot_that_does_not_come_to_rest_is_not_planned_for)
{
  drive_towards(kEast);
  controller->be_unstoppable();
  send_action(kNorth);
  expect_end("ABORTED", "the controller has not come to rest for 20 s");
  EXPECT_TRUE(wait_for_status("drive_failed", kNorth));
  EXPECT_EQ(statuses_of(kNorth), "stopping drive_failed");
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  ros::init(argc, argv, "test_execution");
  const ros::NodeHandle node;
  // Before the first test: action clients do not come into being before time does.
  fourwis::controller.emplace();
  const int result = fourwis::run_rostest(argc, argv, "test_execution");
  fourwis::controller.reset();
  return result;
}
