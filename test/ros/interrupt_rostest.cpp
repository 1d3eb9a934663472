#include <atomic>
#include <thread>

#include "planner_fixture.h"

namespace fourwis
{
namespace
{

const Pose kStart{10, 10, 0};
/// In a slot that is too short to steer into: a robot that moved freely would get there, one that only drives like a
/// car does not, and the search does not know until it has been everywhere.
const Pose kSlot{30, 0.7, 0};
const Pose kEasy{14, 10, 0};

nav_msgs::OccupancyGrid map_with_a_slot(double stamp)
{
  nav_msgs::OccupancyGrid map = walled_map(60.0, 0.1, stamp);
  occupy(5.0, 0.1, 24.3, 1.2, map);
  occupy(30.7, 0.1, 24.3, 1.2, map);
  return map;
}

class Interrupt : public PlannerFixture
{
protected:
  void SetUp() override
  {
    PlannerFixture::SetUp();
    set_map(map_with_a_slot(++stamp_));
    set_start(kStart);
    statuses_.clear();
  }

  void begin_long_plan()
  {
    send_goal(kSlot);
    ASSERT_TRUE(wait_for_status("planning", kSlot));
  }

  bool is_planning(const Pose& goal)
  {
    bool planning = false;
    for (const auto& status : statuses_.messages())
      if (status->goal.pose.position.x == goal.x) planning = status->state == PlannerStatus::PLANNING;
    return planning;
  }

  /// The statuses of these goals, in order.
  std::vector<std::string> statuses_of(const std::vector<Pose>& goals)
  {
    std::vector<std::string> names;
    for (const auto& status : statuses_.messages())
      for (std::size_t i = 0; i < goals.size(); ++i)
        if (status->goal.pose.position.x == goals[i].x) names.push_back(status->status + ' ' + std::to_string(i));
    return names;
  }

  static double stamp_;
};

double Interrupt::stamp_ = 0.0;

TEST_F(Interrupt, a_new_goal_interrupts_the_plan_that_runs)
{
  begin_long_plan();
  send_goal(kEasy);
  ASSERT_TRUE(wait_for_status("succeeded", kEasy));
  EXPECT_EQ(statuses_of({kSlot, kEasy}),
            (std::vector<std::string>{"planning 0", "cancelled 0", "planning 1", "succeeded 1"}));
}

TEST_F(Interrupt, cancel_ends_the_plan_that_runs_and_the_last_good_one_stays)
{
  const ros::Time before = ros::Time::now();
  send_goal(kEasy);
  const auto published = wait_for_trajectory_since(before);
  ASSERT_TRUE(published);
  begin_long_plan();
  EXPECT_TRUE(cancel().success);
  ASSERT_TRUE(wait_for_status("cancelled", kSlot));
  const auto still = latched_trajectory();
  ASSERT_TRUE(still);
  EXPECT_EQ(still->header.stamp, published->header.stamp);
}

TEST_F(Interrupt, cancel_without_a_plan_does_no_harm)
{
  const auto answer = cancel();
  EXPECT_TRUE(answer.success);
  EXPECT_EQ(answer.message, "nothing was being planned");
}

TEST_F(Interrupt, cancel_ends_a_service_call_too)
{
  // The service goes on until it is cancelled, so the canceller may come as often as it takes.
  std::atomic<bool> answered{false};
  std::thread canceller([&] {
    while (!answered) cancel();
  });
  const PlanTrajectory::Response answer = plan(stamped(kStart), stamped(kSlot), {"ackermann"});
  answered = true;
  canceller.join();
  EXPECT_EQ(answer.status, "cancelled");
}

TEST_F(Interrupt, services_answer_while_a_goal_is_planned)
{
  begin_long_plan();
  EXPECT_EQ(plan(stamped(kStart), stamped(kEasy)).status, "succeeded");
  EXPECT_TRUE(is_planning(kSlot));
  cancel();
  EXPECT_TRUE(wait_for_status("cancelled", kSlot));
}

TEST_F(Interrupt, a_goal_refused_for_its_form_leaves_the_plan_that_runs_alone)
{
  begin_long_plan();
  geometry_msgs::PoseStamped bad = stamped({20, 20, 0});
  bad.pose.orientation.w = 2.0;
  send_goal(bad);
  ASSERT_TRUE(wait_for_status("invalid_input", {20, 20, 0}));
  EXPECT_TRUE(is_planning(kSlot));
  cancel();
  EXPECT_TRUE(wait_for_status("cancelled", kSlot));
}

TEST_F(Interrupt, the_action_is_preempted_by_its_client)
{
  move_base_msgs::MoveBaseGoal goal;
  goal.target_pose = stamped(kSlot);
  action_.sendGoal(goal);
  ASSERT_TRUE(wait_for_status("planning", kSlot));
  action_.cancelGoal();
  ASSERT_TRUE(action_.waitForResult(ros::Duration(kPatience)));
  EXPECT_EQ(action_.getState().toString(), "PREEMPTED");
}

TEST_F(Interrupt, the_action_is_preempted_by_a_goal_on_the_topic)
{
  move_base_msgs::MoveBaseGoal goal;
  goal.target_pose = stamped(kSlot);
  action_.sendGoal(goal);
  ASSERT_TRUE(wait_for_status("planning", kSlot));
  send_goal(kEasy);
  ASSERT_TRUE(action_.waitForResult(ros::Duration(kPatience)));
  EXPECT_EQ(action_.getState().toString(), "PREEMPTED");
  EXPECT_TRUE(wait_for_status("succeeded", kEasy));
}

TEST_F(Interrupt, a_new_map_is_not_mixed_into_the_plan_that_runs)
{
  const ros::Time old(stamp_);
  begin_long_plan();
  // On the new map there is no slot, and services plan on it, but the goal's plan goes on as before.
  nav_msgs::OccupancyGrid filled = map_with_a_slot(++stamp_);
  occupy(29.3, 0.1, 1.4, 1.2, filled);
  set_map(filled);
  EXPECT_EQ(plan(stamped(kStart), stamped({29.9, 0.7, 0})).status, "goal_in_collision");
  EXPECT_TRUE(is_planning(kSlot));
  cancel();
  const auto ended = wait_for_status("cancelled", kSlot);
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->map_stamp, old);

  statuses_.clear();
  send_goal(kSlot);
  const auto next = wait_for_status("goal_in_collision", kSlot);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->map_stamp, filled.header.stamp);
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "test_interrupt");
}
