#include <cmath>
#include <set>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <nav_msgs/Path.h>
#include <visualization_msgs/MarkerArray.h>

#include "fourwis_navigation/model/fingerprint.h"
#include "planner_fixture.h"

namespace fourwis
{
namespace
{

const Pose kStart{2, 2, 0};

/// 10 x 10 m with a wall from the south, which leaves a gap of 3 m in the north.
nav_msgs::OccupancyGrid map_with_a_way(double stamp)
{
  nav_msgs::OccupancyGrid map = walled_map(10.0, 0.1, stamp);
  occupy(5.0, 0.0, 0.2, 7.0, map);
  return map;
}

class Planning : public PlannerFixture
{
protected:
  void SetUp() override
  {
    PlannerFixture::SetUp();
    set_map(map_with_a_way(++stamp_));
    set_start(kStart);
    statuses_.clear();
  }

  Inbox<ModeTrajectory>::Pointer wait_for_trajectory(const Pose& goal)
  {
    return trajectories_.wait_for([&](const ModeTrajectory& t) {
      return !t.points.empty() && std::hypot(t.points.back().x - goal.x, t.points.back().y - goal.y) < 1e-3;
    });
  }

  static double stamp_;
};

double Planning::stamp_ = 0.0;

void expect_from_start_to(const Pose& goal, const ModeTrajectory& trajectory)
{
  EXPECT_EQ(trajectory.header.frame_id, "map");
  ASSERT_GE(trajectory.points.size(), 2u);
  const auto &first = trajectory.points.front(), &last = trajectory.points.back();
  EXPECT_NEAR(first.x, kStart.x, 1e-3);
  EXPECT_NEAR(first.y, kStart.y, 1e-3);
  EXPECT_NEAR(wrap_angle(first.theta - kStart.theta), 0.0, 1e-3);
  EXPECT_NEAR(last.x, goal.x, 1e-3);
  EXPECT_NEAR(last.y, goal.y, 1e-3);
  EXPECT_NEAR(wrap_angle(last.theta - goal.theta), 0.0, 1e-3);
  EXPECT_EQ(first.t, 0.0);
  for (std::size_t i = 1; i < trajectory.points.size(); ++i)
    EXPECT_LE(trajectory.points[i - 1].t, trajectory.points[i].t) << "point " << i;
}

TEST_F(Planning, a_goal_on_the_topic_gives_a_trajectory_and_says_so)
{
  const Pose goal{8, 3, 1.0};
  send_goal(goal);
  ASSERT_TRUE(wait_for_status("planning", goal));
  const auto done = wait_for_status("succeeded", goal);
  ASSERT_TRUE(done);
  EXPECT_EQ(done->state, PlannerStatus::SUCCEEDED);
  EXPECT_TRUE(done->metrics.safe);
  EXPECT_GT(done->metrics.length, 10.0);
  EXPECT_EQ(done->map_stamp, ros::Time(stamp_));
  EXPECT_FALSE(done->message.empty());
  const auto trajectory = wait_for_trajectory(goal);
  ASSERT_TRUE(trajectory);
  expect_from_start_to(goal, *trajectory);
}

TEST_F(Planning, the_plan_and_its_picture_reach_those_who_come_late)
{
  const Pose goal{8, 2, 0.0};
  const ros::Time before = ros::Time::now();
  send_goal(goal);
  const auto trajectory = wait_for_trajectory_since(before);
  ASSERT_TRUE(trajectory);
  Inbox<nav_msgs::Path> plan("move_base/plan"), front_end("move_base/frontend_plan");
  Inbox<visualization_msgs::MarkerArray> markers("move_base/markers"), corridors("move_base/corridors");
  const auto is_new = [&](const auto& message) { return message.header.stamp >= before; };
  for (Inbox<nav_msgs::Path>* inbox : {&plan, &front_end})
  {
    const auto path = inbox->wait_for(is_new);
    ASSERT_TRUE(path);
    EXPECT_EQ(path->header.frame_id, "map");
    ASSERT_FALSE(path->poses.empty());
    EXPECT_NEAR(path->poses.back().pose.position.x, goal.x, 1e-3);
  }
  // `plan` is the trajectory, unlike `frontend_plan`.
  const auto poses = plan.wait_for(is_new)->poses;
  ASSERT_EQ(poses.size(), trajectory->points.size());
  for (std::size_t i = 0; i < poses.size(); ++i) EXPECT_EQ(poses[i].pose.position.x, trajectory->points[i].x);
  const auto shows_it = [&](const visualization_msgs::MarkerArray& a) { return is_new(a.markers.front()); };
  const auto array = markers.wait_for(shows_it);
  ASSERT_TRUE(array);
  std::set<std::string> names;
  for (const auto& marker : array->markers) names.insert(marker.ns);
  EXPECT_EQ(names, (std::set<std::string>{"path", "footprints", "switches", "start", "goal", "failure"}));
  const auto regions = corridors.wait_for(shows_it);
  ASSERT_TRUE(regions);
  for (const auto& marker : regions->markers) EXPECT_FALSE(marker.points.empty()) << marker.ns;
}

TEST_F(Planning, staying_where_it_is_is_a_plan)
{
  send_goal(kStart);
  EXPECT_TRUE(wait_for_status("succeeded", kStart));
}

TEST_F(Planning, make_plan_answers_without_publishing_a_plan)
{
  send_goal(Pose{3, 4, 0});
  ASSERT_TRUE(wait_for_trajectory({3, 4, 0}));
  nav_msgs::GetPlan call;
  call.request.start = stamped({2, 8, 0});
  call.request.goal = stamped({8, 8, 0});
  ASSERT_TRUE(ros::service::call("/move_base/make_plan", call));
  ASSERT_FALSE(call.response.plan.poses.empty());
  EXPECT_EQ(call.response.plan.header.frame_id, "map");
  EXPECT_NEAR(call.response.plan.poses.front().pose.position.y, 8.0, 1e-3);
  EXPECT_NEAR(call.response.plan.poses.back().pose.position.x, 8.0, 1e-3);
  const auto published = latched_trajectory();
  ASSERT_TRUE(published);
  EXPECT_NEAR(published->points.back().x, 3.0, 1e-3);
}

TEST_F(Planning, make_plan_starts_at_the_robot_when_the_start_has_no_frame)
{
  nav_msgs::GetPlan call;
  call.request.goal = stamped({3, 4, 0});
  ASSERT_TRUE(ros::service::call("/move_base/make_plan", call));
  ASSERT_FALSE(call.response.plan.poses.empty());
  EXPECT_NEAR(call.response.plan.poses.front().pose.position.x, kStart.x, 1e-3);
  EXPECT_NEAR(call.response.plan.poses.front().pose.position.y, kStart.y, 1e-3);
}

TEST_F(Planning, make_plan_relaxes_a_goal_in_an_obstacle_by_the_tolerance)
{
  // The wall ends 0.2 m east of x = 5; the body is 0.31 m wide to each side of C.
  const Pose in_the_wall{5.1, 3.0, M_PI_2};
  nav_msgs::GetPlan call;
  call.request.start = stamped({8, 3, M_PI_2});
  call.request.goal = stamped(in_the_wall);
  const auto reached = [&](float tolerance) {
    call.request.tolerance = tolerance;
    EXPECT_TRUE(ros::service::call("/move_base/make_plan", call));
    return call.response.plan.poses;
  };
  EXPECT_TRUE(reached(0.0f).empty());
  EXPECT_TRUE(reached(0.3f).empty()) << "no free pose is that near";
  EXPECT_TRUE(reached(-1.0f).empty());
  EXPECT_TRUE(reached(std::nanf("")).empty());
  const auto poses = reached(1.0f);
  ASSERT_FALSE(poses.empty());
  const Pose end = to_pose(poses.back().pose, "end");
  EXPECT_LE(distance(end, in_the_wall), 1.0 + 1e-3);
  EXPECT_GE(std::abs(end.x - in_the_wall.x), 0.1 + 0.31 - 1e-3);
  EXPECT_NEAR(wrap_angle(end.theta - in_the_wall.theta), 0.0, 1e-3);
  const auto again = reached(1.0f);
  ASSERT_EQ(again.size(), poses.size());
  EXPECT_EQ(again.back().pose, poses.back().pose);
}

TEST_F(Planning, plan_trajectory_uses_only_the_modes_it_is_given)
{
  // Sideways by two metres: each mode gets there, each in its own way.
  const std::map<std::string, std::uint8_t> modes = {{"ackermann", 1}, {"lateral", 2}, {"parallel", 3}};
  for (const auto& [name, number] : modes)
  {
    SCOPED_TRACE(name);
    const PlanTrajectory::Response answer = plan(stamped({2, 5, 0}), stamped({2, 7, 0}), {name});
    EXPECT_TRUE(answer.success) << answer.status << ": " << answer.message;
    ASSERT_FALSE(answer.trajectory.points.empty());
    for (const auto& point : answer.trajectory.points) EXPECT_EQ(point.mode, number);
  }
}

TEST_F(Planning, the_action_succeeds_when_the_plan_is_published_and_feeds_back_where_the_robot_is)
{
  move_base_msgs::MoveBaseGoal goal;
  goal.target_pose = stamped({8, 8, 0});
  Inbox<move_base_msgs::MoveBaseActionFeedback> feedback("move_base/feedback");
  ASSERT_TRUE(wait_until([&] { return feedback.connected(); }));
  const auto state = action_.sendGoalAndWait(goal, ros::Duration(kPatience), ros::Duration(1.0));
  EXPECT_EQ(state.toString(), "SUCCEEDED");
  EXPECT_TRUE(wait_for_trajectory({8, 8, 0}));
  const auto position = feedback.wait_for_any();
  ASSERT_TRUE(position);
  EXPECT_NEAR(position->feedback.base_position.pose.position.x, kStart.x, 1e-9);
  EXPECT_EQ(position->feedback.base_position.header.frame_id, "map");
}

TEST_F(Planning, the_action_aborts_with_the_reason_when_there_is_no_plan)
{
  move_base_msgs::MoveBaseGoal goal;
  goal.target_pose = stamped({5.1, 3, 0});
  const auto state = action_.sendGoalAndWait(goal, ros::Duration(kPatience), ros::Duration(1.0));
  EXPECT_EQ(state.toString(), "ABORTED");
  EXPECT_NE(state.getText().find("in collision"), std::string::npos) << state.getText();
  EXPECT_TRUE(wait_for_status("goal_in_collision", {5.1, 3, 0}));
}

TEST_F(Planning, a_map_update_changes_the_answer)
{
  const auto east = [this] { return plan(stamped(kStart), stamped({8, 2, 0})); };
  EXPECT_EQ(east().status, "succeeded");

  map_msgs::OccupancyGridUpdate gap;
  gap.header.frame_id = "map";
  gap.header.stamp = ros::Time(++stamp_);
  gap.x = 50;
  gap.y = 70;
  gap.width = 2;
  gap.height = 30;
  gap.data.assign(gap.width * gap.height, 100);
  update_.publish(gap);
  wait_for_map(gap.header.stamp);
  EXPECT_EQ(east().status, "goal_unreachable");

  gap.data.assign(gap.width * gap.height, 0);
  gap.header.stamp = ros::Time(++stamp_);
  update_.publish(gap);
  wait_for_map(gap.header.stamp);
  EXPECT_EQ(east().status, "succeeded");
}

TEST_F(Planning, diagnostics_tell_of_the_map_and_the_last_plan)
{
  Inbox<diagnostic_msgs::DiagnosticArray> diagnostics("/diagnostics");
  const auto array = diagnostics.wait_for([](const diagnostic_msgs::DiagnosticArray& a) {
    return a.status.size() == 2 && a.status[0].message == "map received";
  });
  ASSERT_TRUE(array);
  EXPECT_EQ(array->status[0].name, "move_base: map");
  EXPECT_EQ(array->status[1].name, "move_base: plan");
  EXPECT_EQ(array->status[1].values.front().value, fingerprint(Robot()));
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "test_planning");
}
