#include "fourwis_navigation/ros/goal_server.h"

#include "fourwis_navigation/ros/conversions.h"

namespace fourwis
{

GoalServer::GoalServer(const PoseSource& poses, const MapPlanner& planner, const ModeSet& modes, PlannerTopics& topics)
  : poses_(poses),
    planner_(planner),
    modes_(modes),
    topics_(topics),
    action_server_(
      node_, "move_base", [this](GoalHandle goal) { on_action_goal(goal); },
      [this](GoalHandle goal) { on_action_cancel(goal); }, false)
{
  goal_subscriber_ = node_.subscribe<geometry_msgs::PoseStamped>(
    "move_base_simple/goal", 10,
    [this](const geometry_msgs::PoseStampedConstPtr& goal) { start(*goal, std::nullopt); });
  action_server_.start();
}

void GoalServer::on_action_goal(GoalHandle goal)
{
  goal.setAccepted("planning");
  if (const PlanWorker::Ticket ticket = start(goal.getGoal()->target_pose, goal)) active_ = Active{goal, ticket};
}

void GoalServer::on_action_cancel(GoalHandle goal)
{
  // Goals before the newest are cancelled already.
  if (active_ && active_->goal == goal) *active_->ticket = true;
}

PlanWorker::Ticket GoalServer::start(const geometry_msgs::PoseStamped& goal, std::optional<GoalHandle> action)
{
  try
  {
    const PlanRequest request{poses_.robot(ros::Time::now()), poses_.to_global(goal, "goal"), modes_};
    return worker_.submit([this, goal, request, action](const std::atomic<bool>& cancelled)
                          { run(goal, request, action, cancelled); });
  }
  catch (const ConversionError& error)
  {
    topics_.publish_refusal(goal, error.what());
    if (action) action->setAborted({}, error.what());
    return nullptr;
  }
}

void GoalServer::run(const geometry_msgs::PoseStamped& goal, const PlanRequest& request,
                     std::optional<GoalHandle> action, const std::atomic<bool>& cancelled)
{
  topics_.publish_planning(goal);
  if (action) publish_feedback(request.start, *action);
  const PlanAnswer answer = planner_.plan(request, cancelled);
  topics_.publish(goal, answer);
  if (!action) return;
  switch (answer.result.status)
  {
    case PlanStatus::succeeded: action->setSucceeded({}, answer.result.message); return;
    case PlanStatus::cancelled: action->setCanceled({}, answer.result.message); return;
    default: action->setAborted({}, answer.result.message);
  }
}

void GoalServer::publish_feedback(const Pose& robot, GoalHandle action) const
{
  move_base_msgs::MoveBaseFeedback feedback;
  feedback.base_position.header = topics_.header();
  feedback.base_position.pose = to_message(robot);
  action.publishFeedback(feedback);
}

}  // namespace fourwis
