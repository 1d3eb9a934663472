#include "global_planner.h"

#include <utility>

#include "conversions.h"

namespace fourwis
{

using fourwis_navigation::Tracking;

GlobalPlanner::GlobalPlanner(const GlobalPlannerParameters& parameters)
  : tf_listener_(tf_),
    topics_(parameters.node, parameters.robot),
    poses_(parameters.node, tf_),
    maps_(parameters.node.global_frame, parameters.robot, parameters.planner,
          [this](const std::string& message) { topics_.publish_refusal({}, message); }),
    planner_(Planner(parameters.planner), maps_,
             parameters.node.show_expansions || parameters.node.show_corridors || parameters.node.show_iterations),
    diagnostics_(parameters.robot, maps_, topics_),
    drive_(parameters.node.controller_patience),
    execution_(parameters.node, poses_, maps_, planner_, drive_, topics_),
    goals_(parameters.node, poses_, planner_, execution_, topics_),
    services_(parameters.robot, poses_, planner_, parameters.node.modes, goals_, topics_)
{
  ros::NodeHandle node;
  map_subscriber_ = node.subscribe<nav_msgs::OccupancyGrid>(
      "map", 10, [this](const nav_msgs::OccupancyGridConstPtr& map) { maps_.add(map); });
  update_subscriber_ = node.subscribe<map_msgs::OccupancyGridUpdate>(
      "map_updates", 100, [this](const map_msgs::OccupancyGridUpdateConstPtr& update) { maps_.add(update); });
  if (parameters.node.wait_for_controller)
    tracking_subscriber_ = node.subscribe("tracking", 100, &GlobalPlanner::on_tracking, this);
  if (parameters.node.start_from == StartFrom::initial_pose)
    initial_pose_subscriber_ = node.subscribe("initialpose", 10, &GlobalPlanner::on_initial_pose, this);
}

void GlobalPlanner::on_tracking(const fourwis_navigation::TrackingConstPtr& tracking)
{
  drive_.reported(*tracking, ros::Time::now());
  const bool drives = tracking->state == Tracking::ALIGNING || tracking->state == Tracking::DRIVING;
  // What it drives when it is first heard was sent by an earlier planner. Nothing checks it against the map.
  if (!std::exchange(controller_heard_, true) && drives) goals_.cancel();
}

void GlobalPlanner::on_initial_pose(const geometry_msgs::PoseWithCovarianceStampedConstPtr& pose)
{
  try
  {
    poses_.set_initial(*pose);
  }
  catch (const ConversionError& error)
  {
    topics_.publish_refusal({}, error.what());
  }
}

}  // namespace fourwis
