#include <limits>

#include "planner_fixture.h"

namespace fourwis
{
namespace
{

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const Pose kStart{2, 2, 0}, kGoal{7, 7, 1.5};

/// First in this file, so that it runs first: later the planner has both.
TEST(ANewPlanner, refuses_goals_before_it_has_a_start_pose_and_a_map)
{
  ASSERT_TRUE(wait_until([] { return ros::service::exists("/move_base/plan_trajectory", false); }));
  PlanTrajectory call;
  call.request.goal = stamped(kGoal);
  ASSERT_TRUE(ros::service::call("/move_base/plan_trajectory", call));
  EXPECT_EQ(call.response.status, "invalid_input");
  EXPECT_NE(call.response.message.find("start pose: none received yet"), std::string::npos) << call.response.message;

  call.request.start = stamped(kStart);
  ASSERT_TRUE(ros::service::call("/move_base/plan_trajectory", call));
  EXPECT_EQ(call.response.status, "invalid_input");
  EXPECT_NE(call.response.message.find("no usable map"), std::string::npos) << call.response.message;
}

/// After each bad input the plan to kGoal is still the one published, and the planner still plans.
class BadInput : public PlannerFixture
{
protected:
  void SetUp() override
  {
    PlannerFixture::SetUp();
    set_map(good_map());
    set_start(kStart);
    const ros::Time before = ros::Time::now();
    send_goal(kGoal);
    ASSERT_TRUE(statuses_.wait_for(
        [&](const PlannerStatus& status) { return status.status == "succeeded" && status.header.stamp >= before; }));
    const auto published = wait_for_trajectory_since(before);
    ASSERT_TRUE(published);
    published_ = published->header.stamp;
    statuses_.clear();
  }

  void TearDown() override
  {
    const auto trajectory = latched_trajectory();
    ASSERT_TRUE(trajectory);
    EXPECT_EQ(trajectory->header.stamp, published_) << "the last good plan was replaced";
    ASSERT_FALSE(trajectory->points.empty());
    EXPECT_NEAR(trajectory->points.back().x, kGoal.x, 1e-3);
    EXPECT_EQ(plan(stamped(kStart), stamped(kGoal)).status, "succeeded");
  }

  static nav_msgs::OccupancyGrid good_map()
  {
    nav_msgs::OccupancyGrid map = walled_map(10.0, 0.1, ++stamp_);
    occupy(4.0, 4.0, 1.0, 1.0, map);
    return map;
  }

  void expect_refused(const std::string& status, const std::string& part)
  {
    const auto refused = statuses_.wait_for([](const PlannerStatus& s) { return s.state == PlannerStatus::FAILED; });
    ASSERT_TRUE(refused) << "nothing was refused";
    EXPECT_EQ(refused->status, status);
    EXPECT_NE(refused->message.find(part), std::string::npos) << "'" << refused->message << "' lacks '" << part << "'";
    statuses_.clear();
  }

  void expect_map_refused(const nav_msgs::OccupancyGrid& map, const std::string& part)
  {
    map_.publish(map);
    expect_refused("invalid_input", part);
  }

  /// By the topic, by the action and by both services.
  void expect_goal_refused(const geometry_msgs::PoseStamped& goal, const std::string& status, const std::string& part)
  {
    send_goal(goal);
    expect_refused(status, part);

    move_base_msgs::MoveBaseGoal action_goal;
    action_goal.target_pose = goal;
    const auto state = action_.sendGoalAndWait(action_goal, ros::Duration(kPatience), ros::Duration(1.0));
    EXPECT_EQ(state.toString(), "ABORTED");
    EXPECT_NE(state.getText().find(part), std::string::npos) << "'" << state.getText() << "' lacks '" << part << "'";
    expect_refused(status, part);

    nav_msgs::GetPlan call;
    call.request.goal = goal;
    ASSERT_TRUE(ros::service::call("/move_base/make_plan", call));
    EXPECT_TRUE(call.response.plan.poses.empty());

    const PlanTrajectory::Response answer = plan(stamped({}, ""), goal);
    EXPECT_FALSE(answer.success);
    EXPECT_EQ(answer.status, status);
    EXPECT_NE(answer.message.find(part), std::string::npos) << "'" << answer.message << "' lacks '" << part << "'";
    EXPECT_TRUE(answer.trajectory.points.empty());
  }

  static double stamp_;
  ros::Time published_;
};

double BadInput::stamp_ = 0.0;

TEST_F(BadInput, a_map_whose_data_does_not_match_its_size_is_refused)
{
  nav_msgs::OccupancyGrid map = good_map();
  map.data.pop_back();
  expect_map_refused(map, "data holds 9999 cells, expected width x height = 100 x 100");
}

TEST_F(BadInput, a_map_without_a_resolution_is_refused)
{
  nav_msgs::OccupancyGrid map = good_map();
  for (float resolution : {0.0f, -0.1f, std::numeric_limits<float>::quiet_NaN()})
  {
    map.info.resolution = resolution;
    expect_map_refused(map, "map: resolution");
  }
}

TEST_F(BadInput, an_empty_map_is_refused)
{
  nav_msgs::OccupancyGrid map;
  map.header.frame_id = "map";
  expect_map_refused(map, "size is 0 x 0 cells");
}

TEST_F(BadInput, a_map_whose_origin_is_no_pose_is_refused)
{
  nav_msgs::OccupancyGrid map = good_map();
  map.info.origin.orientation.w = 0.5;
  expect_map_refused(map, "map: origin: orientation");
  map.info.origin.orientation.w = kNaN;
  expect_map_refused(map, "map: origin: orientation");
  map = good_map();
  map.info.origin.position.x = kNaN;
  expect_map_refused(map, "map: origin: position");
}

TEST_F(BadInput, a_map_in_another_frame_is_refused)
{
  nav_msgs::OccupancyGrid map = good_map();
  map.header.frame_id = "odom";
  expect_map_refused(map, "expected the global_frame 'map'");
}

TEST_F(BadInput, a_map_update_out_of_bounds_is_refused)
{
  map_msgs::OccupancyGridUpdate update;
  update.header.frame_id = "map";
  update.x = 100;
  update.width = update.height = 1;
  update.data = {100};
  update_.publish(update);
  expect_refused("invalid_input", "do not lie in the map");
}

TEST_F(BadInput, a_goal_whose_quaternion_is_not_normalised_is_refused)
{
  geometry_msgs::PoseStamped goal = stamped({7, 7, 0});
  for (double w : {0.0, 0.99, 2.0, kNaN})
  {
    goal.pose.orientation.w = w;
    expect_goal_refused(goal, "invalid_input", "goal: orientation");
  }
}

TEST_F(BadInput, a_goal_tilted_out_of_the_plane_is_refused)
{
  geometry_msgs::PoseStamped goal = stamped({7, 7, 0});
  goal.pose.orientation.x = goal.pose.orientation.w = std::sqrt(0.5);
  expect_goal_refused(goal, "invalid_input", "goal: orientation is tilted");
}

TEST_F(BadInput, a_goal_whose_position_is_not_finite_is_refused)
{
  expect_goal_refused(stamped({kNaN, 7, 0}), "invalid_input", "goal: position");
}

TEST_F(BadInput, a_goal_in_a_frame_that_tf_does_not_know_is_refused_by_name)
{
  expect_goal_refused(stamped({7, 7, 0}, "moon"), "invalid_input", "no transform from 'moon' to 'map'");
  expect_goal_refused(stamped({7, 7, 0}, ""), "invalid_input", "header.frame_id is empty");
}

TEST_F(BadInput, a_goal_in_collision_or_off_the_map_is_refused)
{
  expect_goal_refused(stamped({4.5, 4.5, 0}), "goal_in_collision", "the goal (4.500, 4.500, 0.000)");
  expect_goal_refused(stamped({-100, 4.5, 0}), "goal_in_collision", "the goal (-100.000, 4.500, 0.000)");
  expect_goal_refused(stamped({1e300, 7, 0}), "goal_in_collision", "the goal");
}

TEST_F(BadInput, a_start_in_collision_or_off_the_map_is_refused)
{
  for (const Pose& start : {Pose{4.5, 4.5, 0}, Pose{-100, 0, 0}})
  {
    const PlanTrajectory::Response answer = plan(stamped(start), stamped(kGoal));
    EXPECT_EQ(answer.status, "start_in_collision");
    EXPECT_NE(answer.message.find("the start"), std::string::npos) << answer.message;
  }
}

TEST_F(BadInput, an_unknown_mode_is_refused_by_name)
{
  const PlanTrajectory::Response answer = plan(stamped(kStart), stamped(kGoal), {"ackermann", "sideways"});
  EXPECT_FALSE(answer.success);
  EXPECT_EQ(answer.status, "invalid_input");
  EXPECT_NE(answer.message.find("'sideways' is unknown, expected ackermann, lateral or parallel"), std::string::npos)
      << answer.message;
}

TEST_F(BadInput, an_initial_pose_that_is_no_pose_is_refused_and_the_last_one_counts)
{
  geometry_msgs::PoseWithCovarianceStamped pose;
  pose.header.frame_id = "map";
  initial_pose_.publish(pose);
  expect_refused("invalid_input", "initialpose: orientation");
  const PlanTrajectory::Response answer = plan(stamped({}, ""), stamped(kGoal));
  ASSERT_FALSE(answer.trajectory.points.empty());
  EXPECT_NEAR(answer.trajectory.points.front().x, kStart.x, 1e-3);
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "test_bad_input");
}
