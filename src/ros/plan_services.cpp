#include "plan_services.h"

#include <ros/console.h>

#include "conversions.h"

namespace fourwis
{

using fourwis_navigation::PlanTrajectory;

PlanServices::PlanServices(const Robot& robot, const PoseSource& poses, const MapPlanner& planner, const ModeSet& modes,
                           GoalServer& goals, const PlannerTopics& topics)
  : robot_(robot),
    poses_(poses),
    planner_(planner),
    modes_(modes),
    goals_(goals),
    topics_(topics),
    spinner_(1, &queue_)
{
  ros::NodeHandle node("~"), planning_node("~");
  planning_node.setCallbackQueue(&queue_);
  make_plan_ = planning_node.advertiseService<nav_msgs::GetPlan::Request, nav_msgs::GetPlan::Response>(
      "make_plan", [this](auto& request, auto& response) { return make_plan(request, response), true; });
  plan_trajectory_ = planning_node.advertiseService<PlanTrajectory::Request, PlanTrajectory::Response>(
      "plan_trajectory", [this](auto& request, auto& response) { return plan_trajectory(request, response), true; });
  cancel_ = node.advertiseService<std_srvs::Trigger::Request, std_srvs::Trigger::Response>(
      "cancel", [this](auto&, auto& response) { return cancel(response), true; });
  spinner_.start();
}

PlanServices::~PlanServices()
{
  cancelled_ = true;
  spinner_.stop();
}

void PlanServices::make_plan(const nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response)
{
  response.plan.header = topics_.header();
  try
  {
    PlanRequest question = {start_pose(request.start), poses_.to_global(request.goal, "goal"), modes_};
    question.goal_tolerance = static_cast<double>(request.tolerance);
    const PlanAnswer answer = plan(question);
    if (answer.result.status == PlanStatus::succeeded)
      response.plan = to_path_message(answer.result.trajectory, response.plan.header);
    else
      ROS_WARN("make_plan: %s", answer.result.message.c_str());
  }
  catch (const ConversionError& error)
  {
    ROS_WARN("make_plan: %s", error.what());
  }
}

void PlanServices::plan_trajectory(const PlanTrajectory::Request& request, PlanTrajectory::Response& response)
{
  response.trajectory.header = topics_.header();
  try
  {
    const PlanAnswer answer =
        plan({start_pose(request.start), poses_.to_global(request.goal, "goal"), to_modes(request.modes)});
    const PlanResult& result = answer.result;
    response.success = result.status == PlanStatus::succeeded;
    response.status = to_string(result.status);
    response.message = result.message;
    response.metrics = to_message(result.metrics);
    response.map_stamp = answer.map_stamp;
    if (response.success) response.trajectory = to_message(robot_, result.trajectory, response.trajectory.header);
  }
  catch (const ConversionError& error)
  {
    response.status = to_string(PlanStatus::invalid_input);
    response.message = error.what();
  }
}

void PlanServices::cancel(std_srvs::Trigger::Response& response)
{
  const bool goal = goals_.cancel();
  cancelled_ = true;
  response.success = true;
  response.message = goal || planning_ ? "cancelled" : "nothing was being planned";
}

Pose PlanServices::start_pose(const geometry_msgs::PoseStamped& start) const
{
  return start.header.frame_id.empty() ? poses_.robot(ros::Time::now()) : poses_.to_global(start, "start");
}

PlanAnswer PlanServices::plan(const PlanRequest& request)
{
  cancelled_ = false;
  planning_ = true;
  PlanAnswer answer = planner_.plan(request, cancelled_);
  planning_ = false;
  return answer;
}

}  // namespace fourwis
