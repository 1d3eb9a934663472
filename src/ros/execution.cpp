#include "execution.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include <ros/duration.h>

#include "conversions.h"
#include "plausible_stamp.h"

namespace fourwis
{
namespace
{

using fourwis_navigation::PlannerStatus;

/// Whoever enables a base does not expect it to go on to a goal from before.
constexpr const char* kDisabled = "the base was not enabled at some time since the goal was given; give a new one";

/// Nobody notifies when something happens that a trip waits for.
void nap()
{
  ros::WallDuration(0.005).sleep();
}

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
  Trip trip{goal, cancelled, goal.given, "a new goal", options_.replan_attempts, {}};
  while (true)
  {
    if (const Ended ended = come_to_rest(trip)) return *ended;
    if (const Ended ended = send_plan(trip)) return *ended;
    if (const Ended ended = drive(trip)) return *ended;
  }
}

Execution::Ended Execution::come_to_rest(Trip& trip)
{
  const auto rests = [this] { return monitor_.at_rest_since(ros::Time::now()).has_value(); };
  if (!options_.wait_for_controller || rests()) return std::nullopt;
  topics_.publish_progress(trip.goal.asked, PlannerStatus::STOPPING, "stopping", "stopping: " + trip.reason);
  // A map's stamp may lie ahead, more than a clock that is replayed lags behind.
  const ros::Duration delay(options_.stop_delay);
  send_stop(std::min(trip.occasion, ros::Time::now() + delay) + delay);
  for (; !trip.cancelled; nap())
  {
    if (rests()) return std::nullopt;
    const DriveReport report = monitor_.report(ros::Time::now());
    if (report.phase == DrivePhase::lost) return failed(trip, report.message);
  }
  return cancelled(trip);
}

Execution::Ended Execution::send_plan(Trip& trip)
{
  topics_.publish_progress(trip.goal.asked, PlannerStatus::PLANNING, "planning", "planning: " + trip.reason);
  try
  {
    const ros::Time rest = monitor_.at_rest_since(ros::Time::now()).value_or(trip.goal.given);
    const ros::Time from = std::max(trip.goal.given, rest);
    const PlanRequest request{poses_.robot_at(from, trip.cancelled), trip.goal.pose, options_.modes};
    return send(trip, planner_.plan(request, trip.cancelled), from + ros::Duration(options_.start_delay));
  }
  catch (const ConversionError& error)
  {
    topics_.publish_refusal(trip.goal.asked, error.what());
    return GoalOutcome{GoalOutcome::End::failed, error.what()};
  }
}

Execution::Ended Execution::send(Trip& trip, const PlanAnswer& answer, const ros::Time& begin)
{
  const bool succeeded = answer.result.status == PlanStatus::succeeded;
  if (succeeded && monitor_.enabled_again_since(trip.goal.given)) return failed(trip, kDisabled);
  if (succeeded) sent_ = distinct(begin);
  if (succeeded) monitor_.sending_trajectory(sent_, ros::Time::now());
  topics_.publish(trip.goal.asked, answer, sent_);
  if (!succeeded || !options_.wait_for_controller) return outcome_of(answer.result);
  trip.trajectory = answer.result.trajectory;
  return std::nullopt;
}

Execution::Ended Execution::drive(Trip& trip)
{
  MapStore::Snapshot checked;
  bool announced = false;
  for (; !trip.cancelled; nap())
  {
    const DriveReport report = monitor_.report(ros::Time::now());
    if (report.phase == DrivePhase::arrived) return arrived(trip, report);
    if (report.phase == DrivePhase::failed) return given_up(trip, report);
    if (report.phase == DrivePhase::lost) return failed(trip, report.message);
    if (monitor_.enabled_again_since(trip.goal.given)) return failed(trip, kDisabled);
    if (report.phase == DrivePhase::driving && !std::exchange(announced, true))
      topics_.publish_progress(trip.goal.asked, PlannerStatus::DRIVING, "driving", "driving");
    if (is_blocked(trip, report.t, checked)) return std::nullopt;
  }
  return cancelled(trip);
}

bool Execution::is_blocked(Trip& trip, double t, MapStore::Snapshot& checked) const
{
  const MapStore::Snapshot map = maps_.newest();
  if (map == checked) return false;
  checked = map;
  const auto violation = map->world.referee.first_violation_from(t, trip.trajectory);
  if (!violation) return false;
  trip.occasion = plausible(map->stamp, ros::Time::now(), options_.transform_tolerance);
  trip.reason = "the way is blocked: " + violation->what;
  return true;
}

Execution::Ended Execution::given_up(Trip& trip, const DriveReport& report)
{
  if (trip.attempts_left-- == 0 || monitor_.disabled_since(trip.goal.given)) return failed(trip, report.message);
  trip.occasion = report.since;
  trip.reason = "the controller gave up: " + report.message;
  return std::nullopt;
}

GoalOutcome Execution::arrived(const Trip& trip, const DriveReport& report)
{
  std::ostringstream message;
  message << "arrived in " << (report.since - sent_).toSec() << " s, planned " << trip.trajectory.back().t << " s";
  topics_.publish_progress(trip.goal.asked, PlannerStatus::ARRIVED, "arrived", message.str());
  return {GoalOutcome::End::reached, message.str()};
}

GoalOutcome Execution::failed(const Trip& trip, const std::string& message)
{
  // Also where it is said to be at rest: whoever does not know what the controller does had better not trust that.
  send_stop(ros::Time::now());
  topics_.publish_progress(trip.goal.asked, PlannerStatus::FAILED, "drive_failed", message);
  return {GoalOutcome::End::failed, message};
}

GoalOutcome Execution::cancelled(const Trip& trip)
{
  const std::string message = "cancelled on the way";
  topics_.publish_progress(trip.goal.asked, PlannerStatus::FAILED, to_string(PlanStatus::cancelled), message);
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
