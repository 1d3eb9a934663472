#pragma once

#include <optional>

#include <actionlib/server/action_server.h>
#include <geometry_msgs/PoseStamped.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <ros/timer.h>

#include "execution.h"
#include "map_planner.h"
#include "plan_worker.h"
#include "planner_topics.h"
#include "pose_source.h"

namespace fourwis
{

/// Goals from the topic `move_base_simple/goal` and from the action `move_base`, treated alike: each is pursued on the one
/// worker thread, and a new one takes the place of the one before. A goal that is refused for its form, or because the body is not
/// free there, leaves a running one alone. Accepted goals are published on `~current_goal` in the global frame, stamped with the
/// time from which they
/// count: what a bag replays as goals.
class GoalServer
{
public:
  /// All must outlive this.
  GoalServer(const GlobalPlannerOptions& options, const PoseSource& poses, const MapPlanner& planner,
             Execution& execution, PlannerTopics& topics);

  /// Ends the goal that is pursued and stops the robot; whether there was one. From the thread of the callbacks.
  bool cancel();

private:
  using ActionServer = actionlib::ActionServer<move_base_msgs::MoveBaseAction>;
  using GoalHandle = ActionServer::GoalHandle;

  void on_action_goal(GoalHandle goal);
  void on_action_cancel(GoalHandle goal);
  /// `action` is empty for a goal of the topic.
  void start(const geometry_msgs::PoseStamped& asked, std::optional<GoalHandle> action);
  Goal accept(const geometry_msgs::PoseStamped& asked) const;
  /// Whether a goal is refused because of its place while another one is pursued; then it has been said.
  bool is_misplaced(const geometry_msgs::PoseStamped& asked, std::optional<GoalHandle> action) const;
  void pursue(const Goal& goal, std::optional<GoalHandle> action, const std::atomic<bool>& cancelled);
  void publish_feedback();

  const double stamp_tolerance_;
  const PoseSource& poses_;
  const MapPlanner& planner_;
  Execution& execution_;
  PlannerTopics& topics_;
  std::optional<GoalHandle> active_;  ///< the action goal that was accepted last, unless one of the topic came later
  ros::NodeHandle node_;
  ros::Publisher current_goal_;
  ros::Subscriber goal_subscriber_;
  ros::Timer feedback_timer_;
  ActionServer action_server_;
  PlanWorker worker_;  ///< last: what it runs uses all of the above
};

}  // namespace fourwis
