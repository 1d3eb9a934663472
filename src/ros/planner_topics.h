#pragma once

#include <mutex>
#include <string>
#include <vector>

#include <geometry_msgs/PoseStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <visualization_msgs/MarkerArray.h>

#include "fourwis_navigation/PlannerStatus.h"
#include "fourwis_navigation/parameters/node_parameters.h"
#include "map_planner.h"

namespace fourwis
{

/// Names of the topics for the planner's status, resolved: always `~planner_status`, and the design's `~status` unless
/// that is the status topic of the action `move_base`, as it is in a node of that name.
std::vector<std::string> status_topics();

/// Everything the planner publishes, all of it latched. Only a succeeded plan or a stop replaces the trajectory published
/// before; failures show in the status. Safe to use from several threads at once.
class PlannerTopics
{
public:
  PlannerTopics(const GlobalPlannerOptions& options, const Robot& robot);

  /// Status only; how the way to `goal` goes. `state` and `name` are the message's state and status.
  void publish_progress(const geometry_msgs::PoseStamped& goal, std::uint8_t state, const std::string& name,
                        const std::string& message);
  /// Plan and status for an answer to `goal`; the trajectory begins at `begin`.
  void publish(const geometry_msgs::PoseStamped& goal, const PlanAnswer& answer, const ros::Time& begin);
  /// An empty trajectory: the robot stops at `begin`.
  void publish_stop(const ros::Time& begin);
  /// That the trajectory may be driven on until `free_until` [s] of it.
  void publish_permit(const ros::Time& trajectory, const ros::Time& map_stamp, double free_until,
                      const ros::Time& heard);
  /// Status only; for input that never came to planning. An empty goal: it was about none.
  void publish_refusal(const geometry_msgs::PoseStamped& goal, const std::string& message);
  /// The same for a goal that was judged on a map and not planned to.
  void publish_refusal(const geometry_msgs::PoseStamped& goal, const PlanAnswer& verdict);

  std_msgs::Header header() const;
  fourwis_navigation::PlannerStatus last_status() const;

private:
  void publish_plan(const PlanAnswer& answer, const ros::Time& begin);
  void publish_trajectory(const Trajectory& trajectory, const ros::Time& begin);
  void publish_failure_markers(const PlanAnswer& answer);
  void publish_end(std::uint8_t state, const geometry_msgs::PoseStamped& goal, const PlanAnswer& answer);
  fourwis_navigation::PlannerStatus status(std::uint8_t state, const geometry_msgs::PoseStamped& goal) const;
  void publish_status(const fourwis_navigation::PlannerStatus& status);

  const std::string global_frame_;
  const Robot robot_;
  const bool show_expansions_, show_corridors_, show_iterations_;
  mutable std::mutex mutex_;
  fourwis_navigation::PlannerStatus last_status_;
  visualization_msgs::MarkerArray markers_;  ///< of the last plan that succeeded
  ros::Publisher permit_, trajectory_, plan_, frontend_plan_, marker_, corridors_;
  std::vector<ros::Publisher> status_;
};

}  // namespace fourwis
