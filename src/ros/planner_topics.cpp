#include "planner_topics.h"

#include <nav_msgs/Path.h>
#include <ros/console.h>

#include "conversions.h"
#include "fourwis_navigation/DrivePermit.h"
#include "markers.h"

namespace fourwis
{

using fourwis_navigation::PlannerStatus;

std::vector<std::string> status_topics()
{
  const ros::NodeHandle own("~"), action("move_base");
  std::vector<std::string> topics = {own.resolveName("planner_status")};
  const std::string wanted = own.resolveName("status");
  if (wanted != action.resolveName("status")) topics.push_back(wanted);
  return topics;
}

PlannerTopics::PlannerTopics(const GlobalPlannerOptions& options, const Robot& robot)
  : global_frame_(options.global_frame),
    robot_(robot),
    show_expansions_(options.show_expansions),
    show_corridors_(options.show_corridors),
    show_iterations_(options.show_iterations)
{
  ros::NodeHandle node, private_node("~");
  trajectory_ = node.advertise<fourwis_navigation::ModeTrajectory>("trajectory", 10, true);
  permit_ = node.advertise<fourwis_navigation::DrivePermit>("drive_permit", 1);
  plan_ = private_node.advertise<nav_msgs::Path>("plan", 10, true);
  frontend_plan_ = private_node.advertise<nav_msgs::Path>("frontend_plan", 10, true);
  marker_ = private_node.advertise<visualization_msgs::MarkerArray>("markers", 10, true);
  corridors_ = private_node.advertise<visualization_msgs::MarkerArray>("corridors", 10, true);
  for (const std::string& topic : status_topics()) status_.push_back(node.advertise<PlannerStatus>(topic, 100, true));

  PlannerStatus idle = status(PlannerStatus::IDLE, {});
  idle.status = "idle";
  idle.message = "waiting for a goal";
  publish_status(idle);
}

void PlannerTopics::publish_progress(const geometry_msgs::PoseStamped& goal, std::uint8_t state,
                                     const std::string& name, const std::string& message)
{
  PlannerStatus progress = status(state, goal);
  progress.status = name;
  progress.message = message;
  publish_status(progress);
}

void PlannerTopics::publish(const geometry_msgs::PoseStamped& goal, const PlanAnswer& answer, const ros::Time& begin)
{
  if (answer.result.status != PlanStatus::succeeded)
  {
    publish_failure_markers(answer);
    publish_end(PlannerStatus::FAILED, goal, answer);
    return;
  }
  publish_plan(answer, begin);
  publish_end(PlannerStatus::SUCCEEDED, goal, answer);
}

void PlannerTopics::publish_stop(const ros::Time& begin)
{
  publish_trajectory({}, begin);
}

void PlannerTopics::publish_permit(const ros::Time& trajectory, const ros::Time& map_stamp, double free_until,
                                   const ros::Time& heard)
{
  fourwis_navigation::DrivePermit permit;
  permit.header = header();
  permit.trajectory = trajectory;
  permit.map_stamp = map_stamp;
  permit.free_until = free_until;
  permit.heard = heard;
  permit_.publish(permit);
}

void PlannerTopics::publish_refusal(const geometry_msgs::PoseStamped& goal, const std::string& message)
{
  PlanAnswer verdict;
  verdict.result = no_plan(PlanStatus::invalid_input, message);
  publish_refusal(goal, verdict);
}

void PlannerTopics::publish_refusal(const geometry_msgs::PoseStamped& goal, const PlanAnswer& verdict)
{
  PlannerStatus refused = status(PlannerStatus::FAILED, goal);
  refused.status = to_string(verdict.result.status);
  refused.message = verdict.result.message;
  refused.map_stamp = verdict.map_stamp;
  publish_status(refused);
}

std_msgs::Header PlannerTopics::header() const
{
  std_msgs::Header header;
  header.frame_id = global_frame_;
  header.stamp = ros::Time::now();
  return header;
}

PlannerStatus PlannerTopics::last_status() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_status_;
}

void PlannerTopics::publish_plan(const PlanAnswer& answer, const ros::Time& begin)
{
  const std_msgs::Header now = header();
  const std::lock_guard<std::mutex> lock(mutex_);
  markers_ = plan_markers(robot_, answer.request, answer.result.trajectory, now);
  if (show_expansions_) markers_.markers.push_back(expansion_marker(answer.trace, now));
  if (show_iterations_) markers_.markers.push_back(iteration_marker(answer.trace.iterations(), now));
  publish_trajectory(answer.result.trajectory, begin);
  plan_.publish(to_path_message(answer.result.trajectory, now));
  frontend_plan_.publish(to_path_message(robot_, answer.result.path, now));
  marker_.publish(markers_);
  if (!show_corridors_) return;
  visualization_msgs::MarkerArray corridors;
  corridors.markers = {corridor_marker(show_iterations_ ? answer.trace.all_corridors() : answer.trace.corridors(),
                                       answer.request.start, now)};
  corridors_.publish(corridors);
}

void PlannerTopics::publish_trajectory(const Trajectory& trajectory, const ros::Time& begin)
{
  std_msgs::Header named = header();
  named.stamp = begin;
  trajectory_.publish(to_message(robot_, trajectory, named));
}

void PlannerTopics::publish_failure_markers(const PlanAnswer& answer)
{
  const std_msgs::Header now = header();
  const std::lock_guard<std::mutex> lock(mutex_);
  // The topic is latched: a late subscriber must see the last plan as well. Later markers in the array count.
  visualization_msgs::MarkerArray markers = markers_;
  markers.markers.push_back(failure_marker(answer.request.goal, answer.result.status, now));
  if (show_expansions_) markers.markers.push_back(expansion_marker(answer.trace, now));
  marker_.publish(markers);
}

void PlannerTopics::publish_end(std::uint8_t state, const geometry_msgs::PoseStamped& goal, const PlanAnswer& answer)
{
  PlannerStatus end = status(state, goal);
  end.status = to_string(answer.result.status);
  end.message = answer.result.message;
  end.map_stamp = answer.map_stamp;
  end.metrics = to_message(answer.result.metrics);
  publish_status(end);
}

PlannerStatus PlannerTopics::status(std::uint8_t state, const geometry_msgs::PoseStamped& goal) const
{
  PlannerStatus status;
  status.header = header();
  status.state = state;
  status.goal = goal;
  return status;
}

void PlannerTopics::publish_status(const PlannerStatus& status)
{
  if (status.state == PlannerStatus::FAILED)
    ROS_WARN("%s: %s", status.status.c_str(), status.message.c_str());
  else
    ROS_INFO("%s: %s", status.status.c_str(), status.message.c_str());
  const std::lock_guard<std::mutex> lock(mutex_);
  last_status_ = status;
  for (const ros::Publisher& topic : status_) topic.publish(status);
}

}  // namespace fourwis
