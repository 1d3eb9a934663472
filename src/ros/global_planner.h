#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <tf2/buffer_core.h>
#include <tf2_ros/transform_listener.h>

#include "drive_monitor.h"
#include "execution.h"
#include "fourwis_navigation/parameters/node_parameters.h"
#include "goal_server.h"
#include "map_planner.h"
#include "map_store.h"
#include "plan_services.h"
#include "planner_diagnostics.h"
#include "planner_topics.h"
#include "pose_source.h"

namespace fourwis
{

/// The planner's node: maps and poses come in, the newest map answers goals and services, and what they yield goes out.
/// doc/design.md and README.md describe its topics and services. Spin it with one thread.
class GlobalPlanner
{
public:
  explicit GlobalPlanner(const GlobalPlannerParameters& parameters);

private:
  void on_tracking(const fourwis_navigation::TrackingConstPtr& tracking);
  void on_initial_pose(const geometry_msgs::PoseWithCovarianceStampedConstPtr& pose);

  // In this order: a member is destroyed before those that it uses.
  tf2::BufferCore tf_;
  tf2_ros::TransformListener tf_listener_;
  PlannerTopics topics_;
  PoseSource poses_;
  MapStore maps_;
  MapPlanner planner_;
  PlannerDiagnostics diagnostics_;
  DriveMonitor drive_;
  bool controller_heard_ = false;
  Execution execution_;
  GoalServer goals_;
  PlanServices services_;
  ros::Subscriber map_subscriber_, update_subscriber_, initial_pose_subscriber_, tracking_subscriber_;
};

}  // namespace fourwis
