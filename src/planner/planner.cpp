#include "fourwis_navigation/planner/planner.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/planner/metrics.h"
#include "fourwis_navigation/planner/stop_and_steer.h"
#include "fourwis_navigation/search/front_end.h"

namespace fourwis
{
namespace
{

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point begin)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

template <typename... Numbers>
std::string sentence(const char* format, Numbers... numbers)
{
  char text[256];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

PlanResult refusal(PlanStatus status, std::string message)
{
  PlanResult result;
  result.status = status;
  result.message = std::move(message);
  return result;
}

/// Least clearance of the two disc centres, less the discs' radius [m]; negative in collision.
double disc_clearance(const CollisionChecker& checker, const Pose& pose)
{
  const TwoDiscs& discs = checker.discs();
  const Pose front = compose(pose, {discs.offset, 0.0, 0.0}), rear = compose(pose, {-discs.offset, 0.0, 0.0});
  const ObstacleMap& map = checker.map();
  return std::min(map.distance(front.x, front.y), map.distance(rear.x, rear.y)) - discs.radius;
}

std::string collision_sentence(const char* what, const Pose& pose, double clearance)
{
  return sentence("%s (%.3f, %.3f, %.3f) is in collision: the covering discs are %.3f m too close to an obstacle", what,
                  pose.x, pose.y, pose.theta, -clearance);
}

std::string search_sentence(const SearchResult& found, const PlanRequest& request)
{
  switch (found.status)
  {
    case PlanStatus::goal_unreachable:
      return sentence("the robot cannot get from (%.2f, %.2f, %.2f) to (%.2f, %.2f, %.2f): %s", request.start.x,
                      request.start.y, request.start.theta, request.goal.x, request.goal.y, request.goal.theta,
                      request.modes.ackermann || request.modes.lateral ? "no way is wide enough"
                                                                       : "parallel motion alone does not turn");
    case PlanStatus::timeout:
      return sentence("planner_patience was over after %d expansions", found.expansions);
    case PlanStatus::cancelled:
      return sentence("cancelled after %d expansions", found.expansions);
    default:
      return sentence("no path found in %d expansions", found.expansions);
  }
}

Trajectory stay_at(const Pose& pose, const ModeSet& modes)
{
  TrajectoryPoint point;
  point.mode = modes.first();
  point.x = pose.x;
  point.y = pose.y;
  point.theta = pose.theta;
  return {point};
}

bool same_pose(const Pose& a, const Pose& b)
{
  return distance(a, b) < 1e-6 && std::abs(wrap_angle(a.theta - b.theta)) < 1e-6;
}

}  // namespace

World::World(const OccupancyGrid& occupancy, const Robot& robot, const PlannerOptions& options)
  : World(occupancy, robot, options, Clock::now())
{
}

World::World(const OccupancyGrid& occupancy, const Robot& robot, const PlannerOptions& options,
             Clock::time_point begin)
  : grid(occupancy), obstacles(occupancy, options.obstacles),
    referee(occupancy, options.obstacles, robot, options.verify), build_ms(ms_since(begin))
{
}

Planner::Planner(const Robot& robot, const PlannerOptions& options) : robot_(robot), options_(options) {}

PlanResult Planner::plan(const World& world, const PlanRequest& request, const Interrupt& interrupt,
                         PlanTrace* trace) const
{
  const Clock::time_point begin = Clock::now();
  if (!is_finite(request.start)) return refusal(PlanStatus::invalid_input, "the start pose is not finite");
  if (!is_finite(request.goal)) return refusal(PlanStatus::invalid_input, "the goal pose is not finite");
  if (request.modes.empty()) return refusal(PlanStatus::invalid_input, "no motion mode is allowed");

  const CollisionChecker checker(world.obstacles, robot_);
  if (!checker.is_free(request.start))
    return refusal(PlanStatus::start_in_collision,
                   collision_sentence("the start", request.start, disc_clearance(checker, request.start)));
  if (!checker.is_free(request.goal))
    return refusal(PlanStatus::goal_in_collision,
                   collision_sentence("the goal", request.goal, disc_clearance(checker, request.goal)));

  PlanResult result;
  if (same_pose(request.start, request.goal))
    result.trajectory = stay_at(request.start, request.modes);
  else
  {
    const Interrupt patience = interrupt.or_after(options_.planner_patience);
    SearchResult found =
        find_path(checker, robot_, options_.search, request, patience, trace ? &trace->expanded : nullptr);
    result.metrics.expansions = found.expansions;
    result.path = std::move(found.path);
    if (found.status != PlanStatus::succeeded)
    {
      result.status = found.status;
      result.message = search_sentence(found, request);
    }
    else
      result.trajectory = stop_and_steer(result.path, robot_, options_.search.reference_speed);
  }
  PlanMetrics& metrics = result.metrics;
  metrics.map_ms = world.build_ms;
  metrics.frontend_ms = world.build_ms + ms_since(begin);

  if (!result.trajectory.empty())
  {
    const Clock::time_point judging = Clock::now();
    const Verdict verdict = world.referee.judge(request.start, request.goal, result.trajectory);
    metrics.verify_ms = ms_since(judging);
    metrics.safe = verdict.accepted();
    metrics.min_clearance = verdict.min_clearance;
    metrics.terminal_position_error = verdict.terminal_position_error;
    metrics.terminal_yaw_error = verdict.terminal_yaw_error;
    measure(result.trajectory, robot_, metrics);
    result.status = verdict.accepted() ? PlanStatus::succeeded : PlanStatus::verification_failed;
    result.message = verdict.accepted() ? sentence("%.2f m in %.2f s with %d mode switch%s", metrics.length,
                                                   metrics.arrival_time, metrics.switches,
                                                   metrics.switches == 1 ? "" : "es")
                                        : verdict.violations.front().what;
  }
  metrics.total_ms = world.build_ms + ms_since(begin);
  return result;
}

}  // namespace fourwis
