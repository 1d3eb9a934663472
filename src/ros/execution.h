#pragma once

#include <atomic>
#include <optional>
#include <string>

#include <geometry_msgs/PoseStamped.h>
#include <ros/time.h>

#include "drive_monitor.h"
#include "fourwis_navigation/parameters/node_parameters.h"
#include "map_planner.h"
#include "map_store.h"
#include "planner_topics.h"
#include "pose_source.h"

namespace fourwis
{

/// A goal whose form is right.
struct Goal
{
  geometry_msgs::PoseStamped asked;  ///< as it was requested
  Pose pose;                         ///< in the global frame
  ros::Time given;                   ///< when
};

struct GoalOutcome
{
  enum class End
  {
    reached,  ///< without a controller: the plan is published
    failed,
    cancelled
  };

  End end;
  std::string message;
};

/// Brings the robot to goals: to rest, a plan from there, on its way, and again from the start when the way is blocked or the
/// controller gives up. Without a controller it is the plan alone. To be called from one thread.
class Execution
{
public:
  /// All must outlive this. `monitor` is given what the controller reports.
  Execution(const GlobalPlannerOptions& options, const PoseSource& poses, const MapStore& maps,
            const MapPlanner& planner, DriveMonitor& monitor, PlannerTopics& topics);

  /// Returns when the goal has come to its end, or soon after `cancelled` has become true. Then the robot is left as it
  /// is: the next goal, or halt(), stops it.
  GoalOutcome pursue(const Goal& goal, const std::atomic<bool>& cancelled);

  /// Stops the robot unless it is at rest.
  void halt();

private:
  /// The goal that is pursued.
  struct ActiveGoal
  {
    const Goal& goal;
    const std::atomic<bool>& cancelled;
    ros::Time reason_stamp;  ///< when the last reason to plan arose
    std::string reason;      ///< that reason, in words
    int attempts_left;       ///< to plan anew after the controller has given up
    Trajectory trajectory;
  };
  /// Empty: the goal is pursued further.
  using Ended = std::optional<GoalOutcome>;

  // What is done for a goal, in this order; again from the first when the last has not come to an end.
  Ended come_to_rest(ActiveGoal& active);
  Ended send_plan(ActiveGoal& active);
  Ended drive(ActiveGoal& active);

  Ended send(ActiveGoal& active, const PlanAnswer& answer, const ros::Time& begin);
  Ended given_up(ActiveGoal& active, const DriveReport& report);
  /// Looks at each map once: an obstacle on the way from t [s] on is the reason to plan anew.
  bool is_blocked(ActiveGoal& active, double t, MapStore::Snapshot& checked);
  /// Lets the controller drive on as far as the way is known to be free on the map that was checked.
  void permit(const MapSnapshot& checked, double free_until);
  GoalOutcome arrived(const ActiveGoal& active, const DriveReport& report);
  GoalOutcome failed(const ActiveGoal& active, const std::string& message);
  GoalOutcome cancelled(const ActiveGoal& active);
  void send_stop(const ros::Time& begin);
  void pause();
  ros::Time distinct(const ros::Time& stamp) const;

  const GlobalPlannerOptions options_;
  const PoseSource& poses_;
  const MapStore& maps_;
  const MapPlanner& planner_;
  DriveMonitor& monitor_;
  PlannerTopics& topics_;
  ros::Time permitted_;  ///< the controller's stamp that the last permit told
  ros::Time sent_;       ///< header.stamp of the trajectory or stop that was sent last
};

}  // namespace fourwis
