#include "execution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include <ros/console.h>
#include <ros/duration.h>

#include "conversions.h"
#include "plausible_stamp.h"

namespace fourwis
{
namespace
{

using fourwis_navigation::PlannerStatus;

/// A person who enables a base does not expect it to go on to an earlier goal.
constexpr const char* kDisabled = "the base was not enabled at some time since the goal was given; give a new one";

/// Between two permits [s].
constexpr double kPermitPeriod = 0.05;
/// A map that has been waiting longer to be built may hold anything [s].
constexpr double kLongestMapDelay = 1.0;

/// Between two looks at the controller's reports and the maps: nothing wakes this thread when they change [s].
constexpr double kPollPause = 0.005;
/// A pause that took longer is time in which this process did not run [s].
constexpr double kAsleep = 0.5;

GoalOutcome outcome_of(const PlanResult& result)
{
  switch (result.status)
  {
    case PlanStatus::succeeded: return {GoalOutcome::End::reached, result.message};
    case PlanStatus::cancelled: return {GoalOutcome::End::cancelled, result.message};
    default: return {GoalOutcome::End::failed, result.message};
  }
}

}  // namespace

Execution::Execution(const GlobalPlannerOptions& options, const PoseSource& poses, const MapStore& maps,
                     const MapPlanner& planner, DriveMonitor& monitor, PlannerTopics& topics)
  : options_(options),
    poses_(poses),
    maps_(maps),
    planner_(planner),
    monitor_(monitor),
    topics_(topics)
{}

GoalOutcome Execution::pursue(const Goal& goal, const std::atomic<bool>& cancelled)
{
  ActiveGoal active{goal, cancelled, goal.given, "a new goal", options_.replan_attempts, {}};
  while (true)
  {
    if (const Ended ended = come_to_rest(active)) return *ended;
    if (const Ended ended = send_plan(active)) return *ended;
    if (const Ended ended = drive(active)) return *ended;
  }
}

void Execution::pause()
{
  const ros::WallTime before = ros::WallTime::now();
  ros::WallDuration(kPollPause).sleep();
  if ((ros::WallTime::now() - before).toSec() > kAsleep) monitor_.slept_until(ros::Time::now());
}

Execution::Ended Execution::come_to_rest(ActiveGoal& active)
{
  const auto rests = [this] { return monitor_.at_rest_since(ros::Time::now()).has_value(); };
  if (!options_.wait_for_controller || rests()) return std::nullopt;
  topics_.publish_progress(active.goal.asked, PlannerStatus::STOPPING, "stopping", "stopping: " + active.reason);
  // A map's stamp may lie ahead, more than a clock that is replayed lags behind.
  const ros::Duration delay(options_.stop_delay);
  send_stop(std::min(active.reason_stamp, ros::Time::now() + delay) + delay);
  for (; !active.cancelled; pause())
  {
    if (rests()) return std::nullopt;
    const DriveReport report = monitor_.report(ros::Time::now());
    if (report.phase == DrivePhase::lost) return failed(active, report.message);
  }
  return cancelled(active);
}

Execution::Ended Execution::send_plan(ActiveGoal& active)
{
  topics_.publish_progress(active.goal.asked, PlannerStatus::PLANNING, "planning", "planning: " + active.reason);
  try
  {
    const ros::Time rest = monitor_.at_rest_since(ros::Time::now()).value_or(active.goal.given);
    const ros::Time from = std::max(active.goal.given, rest);
    const PlanRequest request{poses_.robot_at(from, active.cancelled), active.goal.pose, options_.modes};
    return send(active, planner_.plan(request, active.cancelled), from + ros::Duration(options_.start_delay));
  }
  catch (const ConversionError& error)
  {
    topics_.publish_refusal(active.goal.asked, error.what());
    return GoalOutcome{GoalOutcome::End::failed, error.what()};
  }
}

Execution::Ended Execution::send(ActiveGoal& active, const PlanAnswer& answer, const ros::Time& begin)
{
  const bool succeeded = answer.result.status == PlanStatus::succeeded;
  if (succeeded && monitor_.enabled_again_since(active.goal.given)) return failed(active, kDisabled);
  if (succeeded) sent_ = distinct(begin);
  if (succeeded) monitor_.sending_trajectory(sent_, ros::Time::now());
  topics_.publish(active.goal.asked, answer, sent_);
  if (!succeeded || !options_.wait_for_controller) return outcome_of(answer.result);
  active.trajectory = answer.result.trajectory;
  return std::nullopt;
}

Execution::Ended Execution::drive(ActiveGoal& active)
{
  MapStore::Snapshot checked;
  bool announced = false;
  for (; !active.cancelled; pause())
  {
    const DriveReport report = monitor_.report(ros::Time::now());
    if (report.phase == DrivePhase::arrived) return arrived(active, report);
    if (report.phase == DrivePhase::failed) return given_up(active, report);
    if (report.phase == DrivePhase::lost) return failed(active, report.message);
    if (monitor_.enabled_again_since(active.goal.given)) return failed(active, kDisabled);
    if (report.phase == DrivePhase::driving && !std::exchange(announced, true))
      topics_.publish_progress(active.goal.asked, PlannerStatus::DRIVING, "driving", "driving");
    if (is_blocked(active, report.t, checked)) return std::nullopt;
    permit(*checked, std::numeric_limits<double>::infinity());
  }
  return cancelled(active);
}

bool Execution::is_blocked(ActiveGoal& active, double t, MapStore::Snapshot& checked)
{
  const MapStore::Snapshot map = maps_.newest();
  if (map == checked) return false;
  checked = map;
  const auto violation = map->world.first_violation_from(t, active.trajectory);
  if (!violation) return false;
  permit(*map, violation->t);
  active.reason_stamp = plausible(map->stamp, ros::Time::now(), options_.transform_tolerance);
  active.reason = "the way is blocked: " + violation->what;
  return true;
}

/// Each permit answers a report of the controller, and only while no map waits for long: whatever hangs, what hears the
/// controller, builds the maps or runs here, ends the permits.
void Execution::permit(const MapSnapshot& checked, double free_until)
{
  const ros::Time heard = monitor_.newest_stamp();
  const double since = heard.toSec() - permitted_.toSec();
  if (since >= 0.0 && since < kPermitPeriod && std::isinf(free_until)) return;
  if (const double waiting = maps_.waiting(); waiting > kLongestMapDelay)
  {
    ROS_WARN_THROTTLE(1.0, "no permission to drive: a map has been waiting for %.2f s to be looked at", waiting);
    return;
  }
  permitted_ = heard;
  topics_.publish_permit(sent_, checked.stamp, free_until, heard);
}

Execution::Ended Execution::given_up(ActiveGoal& active, const DriveReport& report)
{
  if (active.attempts_left-- == 0 || monitor_.disabled_since(active.goal.given)) return failed(active, report.message);
  active.reason_stamp = report.since;
  active.reason = "the controller gave up: " + report.message;
  return std::nullopt;
}

GoalOutcome Execution::arrived(const ActiveGoal& active, const DriveReport& report)
{
  std::ostringstream message;
  message << "arrived in " << (report.since - sent_).toSec() << " s, planned " << active.trajectory.back().t << " s";
  topics_.publish_progress(active.goal.asked, PlannerStatus::ARRIVED, "arrived", message.str());
  return {GoalOutcome::End::reached, message.str()};
}

GoalOutcome Execution::failed(const ActiveGoal& active, const std::string& message)
{
  // Also if it is said to be at rest: without knowing what the controller does, this cannot be relied on.
  send_stop(ros::Time::now());
  topics_.publish_progress(active.goal.asked, PlannerStatus::FAILED, "drive_failed", message);
  return {GoalOutcome::End::failed, message};
}

GoalOutcome Execution::cancelled(const ActiveGoal& active)
{
  const std::string message = "cancelled on the way";
  topics_.publish_progress(active.goal.asked, PlannerStatus::FAILED, to_string(PlanStatus::cancelled), message);
  return {GoalOutcome::End::cancelled, message};
}

void Execution::halt()
{
  const ros::Time now = ros::Time::now();
  if (options_.wait_for_controller && !monitor_.at_rest_since(now)) send_stop(now);
}

void Execution::send_stop(const ros::Time& begin)
{
  sent_ = distinct(begin);
  monitor_.sending_stop(sent_, ros::Time::now());
  topics_.publish_stop(sent_);
}

ros::Time Execution::distinct(const ros::Time& stamp) const
{
  return stamp == sent_ ? stamp + ros::Duration(0, 1) : stamp;
}

}  // namespace fourwis
