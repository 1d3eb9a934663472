#include "goal_server.h"

#include "conversions.h"
#include "plausible_stamp.h"

namespace fourwis
{
namespace
{

const ros::Duration kFeedbackPeriod(0.1);

}  // namespace

GoalServer::GoalServer(const GlobalPlannerOptions& options, const PoseSource& poses, const MapPlanner& planner,
                       Execution& execution, PlannerTopics& topics)
  : stamp_tolerance_(options.transform_tolerance),
    poses_(poses),
    planner_(planner),
    execution_(execution),
    topics_(topics),
    action_server_(
        node_, "move_base", [this](GoalHandle goal) { on_action_goal(goal); },
        [this](GoalHandle goal) { on_action_cancel(goal); }, false)
{
  current_goal_ = ros::NodeHandle("~").advertise<geometry_msgs::PoseStamped>("current_goal", 10);
  goal_subscriber_ = node_.subscribe<geometry_msgs::PoseStamped>(
      "move_base_simple/goal", 10,
      [this](const geometry_msgs::PoseStampedConstPtr& goal) { start(*goal, std::nullopt); });
  feedback_timer_ = node_.createTimer(kFeedbackPeriod, [this](const ros::TimerEvent&) { publish_feedback(); });
  action_server_.start();
}

bool GoalServer::cancel()
{
  const bool pursued = worker_.cancel();
  worker_.submit([this](const std::atomic<bool>&) { execution_.halt(); });
  return pursued;
}

void GoalServer::on_action_goal(GoalHandle goal)
{
  goal.setAccepted("accepted");
  start(goal.getGoal()->target_pose, goal);
}

void GoalServer::on_action_cancel(GoalHandle goal)
{
  // Goals before the newest are cancelled already.
  if (active_ && *active_ == goal) cancel();
}

void GoalServer::start(const geometry_msgs::PoseStamped& asked, std::optional<GoalHandle> action)
{
  try
  {
    if (is_misplaced(asked, action)) return;
    const Goal goal = accept(asked);
    active_ = action;
    publish_feedback();
    worker_.submit([this, goal, action](const std::atomic<bool>& cancelled) { pursue(goal, action, cancelled); });
  }
  catch (const ConversionError& error)
  {
    topics_.publish_refusal(asked, error.what());
    if (action) action->setAborted({}, error.what());
  }
}

bool GoalServer::is_misplaced(const geometry_msgs::PoseStamped& asked, std::optional<GoalHandle> action) const
{
  if (!worker_.is_busy()) return false;
  const PlanAnswer verdict = planner_.judge_goal(poses_.to_global(asked, "goal"));
  if (verdict.result.status == PlanStatus::succeeded) return false;
  topics_.publish_refusal(asked, verdict);
  if (action) action->setAborted({}, verdict.result.message);
  return true;
}

Goal GoalServer::accept(const geometry_msgs::PoseStamped& asked) const
{
  geometry_msgs::PoseStamped goal = poses_.in_global(asked, "goal");
  goal.header.stamp = plausible(asked.header.stamp, ros::Time::now(), stamp_tolerance_);
  current_goal_.publish(goal);
  return {asked, poses_.to_global(goal, "goal"), goal.header.stamp};
}

void GoalServer::pursue(const Goal& goal, std::optional<GoalHandle> action, const std::atomic<bool>& cancelled)
{
  const GoalOutcome outcome = execution_.pursue(goal, cancelled);
  if (!action) return;
  switch (outcome.end)
  {
    case GoalOutcome::End::reached: action->setSucceeded({}, outcome.message); return;
    case GoalOutcome::End::cancelled: action->setCanceled({}, outcome.message); return;
    case GoalOutcome::End::failed: action->setAborted({}, outcome.message); return;
  }
}

void GoalServer::publish_feedback()
{
  if (!active_ || active_->getGoalStatus().status != actionlib_msgs::GoalStatus::ACTIVE) return;
  move_base_msgs::MoveBaseFeedback feedback;
  feedback.base_position.header = topics_.header();
  try
  {
    feedback.base_position.pose = to_message(poses_.robot(feedback.base_position.header.stamp));
    active_->publishFeedback(feedback);
  }
  catch (const ConversionError&)
  {
    // No feedback while the robot's pose is not known; what depends on the pose says so itself.
  }
}

}  // namespace fourwis
