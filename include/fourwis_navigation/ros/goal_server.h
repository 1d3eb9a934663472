#pragma once

#include <optional>

#include <actionlib/server/action_server.h>
#include <geometry_msgs/PoseStamped.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include "fourwis_navigation/ros/map_planner.h"
#include "fourwis_navigation/ros/plan_worker.h"
#include "fourwis_navigation/ros/planner_topics.h"
#include "fourwis_navigation/ros/pose_source.h"

namespace fourwis
{

/// Goals from the topic `move_base_simple/goal` and from the action `move_base`, treated alike: each is planned on the
/// one worker thread from where the robot is when the goal arrives, and a new one interrupts the one before. A goal
/// that is refused for its form leaves a running plan alone.
class GoalServer
{
public:
  /// All must outlive this.
  GoalServer(const PoseSource& poses, const MapPlanner& planner, const ModeSet& modes, PlannerTopics& topics);

  /// Ends the plan that runs; whether there was one. From any thread.
  bool cancel() { return worker_.cancel(); }

private:
  using ActionServer = actionlib::ActionServer<move_base_msgs::MoveBaseAction>;
  using GoalHandle = ActionServer::GoalHandle;

  /// An action goal that may still be cancelled.
  struct Active
  {
    GoalHandle goal;
    PlanWorker::Ticket ticket;
  };

  void on_action_goal(GoalHandle goal);
  void on_action_cancel(GoalHandle goal);
  /// `action` is empty for a goal of the topic.
  PlanWorker::Ticket start(const geometry_msgs::PoseStamped& goal, std::optional<GoalHandle> action);
  void run(const geometry_msgs::PoseStamped& goal, const PlanRequest& request, std::optional<GoalHandle> action,
           const std::atomic<bool>& cancelled);
  void publish_feedback(const Pose& robot, GoalHandle action) const;

  const PoseSource& poses_;
  const MapPlanner& planner_;
  const ModeSet modes_;
  PlannerTopics& topics_;
  std::optional<Active> active_;
  ros::NodeHandle node_;
  ros::Subscriber goal_subscriber_;
  ActionServer action_server_;
  PlanWorker worker_;  ///< last: what it runs uses all of the above
};

}  // namespace fourwis
