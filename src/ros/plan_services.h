#pragma once

#include <atomic>

#include <nav_msgs/GetPlan.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <ros/spinner.h>
#include <std_srvs/Trigger.h>

#include "fourwis_navigation/PlanTrajectory.h"
#include "goal_server.h"
#include "map_planner.h"
#include "planner_topics.h"
#include "pose_source.h"

namespace fourwis
{

/// `~make_plan` and `~plan_trajectory` answer without publishing a plan, one after the other on a thread of their own,
/// beside goals and callbacks; `~cancel` ends them and the goal's plan. A start without frame_id means the robot's
/// pose. None of it touches the planner's status, which is about the goal. Why there is no plan is in the answer of
/// `~plan_trajectory`, which has a place for it, and of `~make_plan` in the log. `~make_plan` has a tolerance: the last pose of its
/// answer is the one that the plan really gets to.
class PlanServices
{
public:
  /// All but robot and modes must outlive this.
  PlanServices(const Robot& robot, const PoseSource& poses, const MapPlanner& planner, const ModeSet& modes,
               GoalServer& goals, const PlannerTopics& topics);
  /// Cancels what runs.
  ~PlanServices();
  PlanServices(const PlanServices&) = delete;
  PlanServices& operator=(const PlanServices&) = delete;

private:
  void make_plan(const nav_msgs::GetPlan::Request& request, nav_msgs::GetPlan::Response& response);
  void plan_trajectory(const fourwis_navigation::PlanTrajectory::Request& request,
                       fourwis_navigation::PlanTrajectory::Response& response);
  void cancel(std_srvs::Trigger::Response& response);
  Pose start_pose(const geometry_msgs::PoseStamped& start) const;
  PlanAnswer plan(const PlanRequest& request);

  const Robot robot_;
  const PoseSource& poses_;
  const MapPlanner& planner_;
  const ModeSet modes_;
  GoalServer& goals_;
  const PlannerTopics& topics_;
  std::atomic<bool> planning_{false};
  std::atomic<bool> cancelled_{false};
  ros::CallbackQueue queue_;
  ros::ServiceServer make_plan_, plan_trajectory_, cancel_;
  ros::AsyncSpinner spinner_;
};

}  // namespace fourwis
