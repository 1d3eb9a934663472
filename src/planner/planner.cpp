#include "fourwis_navigation/planner/planner.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <numeric>

#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/planner/back_end.h"
#include "fourwis_navigation/planner/candidates.h"
#include "fourwis_navigation/planner/metrics.h"
#include "fourwis_navigation/planner/stop_and_steer.h"
#include "fourwis_navigation/search/front_end.h"
#include "in_parallel.h"

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

/// Polishing makes trajectories faster by up to about this factor.
constexpr double kWorthPolishing = 1.01;

double arrival_time(const Refinement& refinement)
{
  return refinement.trajectory.empty() ? std::numeric_limits<double>::infinity() : refinement.trajectory.back().t;
}

/// A result that is not a plan.
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

std::string search_sentence(PlanStatus status, int expansions, const PlanRequest& request)
{
  switch (status)
  {
    case PlanStatus::goal_unreachable:
      return sentence("the robot cannot get from (%.2f, %.2f, %.2f) to (%.2f, %.2f, %.2f): %s", request.start.x,
                      request.start.y, request.start.theta, request.goal.x, request.goal.y, request.goal.theta,
                      may_turn(request.start, request.goal, request.modes) ? "no way is wide enough" : "parallel motion alone does not turn");
    case PlanStatus::timeout: return sentence("planner_patience was over after %d expansions", expansions);
    case PlanStatus::cancelled: return sentence("cancelled after %d expansions", expansions);
    default: return sentence("no path found in %d expansions", expansions);
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

/// Unusable requests by their status; `succeeded` for all others.
PlanResult refuse(const CollisionChecker& checker, const PlanRequest& request)
{
  if (!is_finite(request.start)) return refusal(PlanStatus::invalid_input, "the start pose is not finite");
  if (!is_finite(request.goal)) return refusal(PlanStatus::invalid_input, "the goal pose is not finite");
  if (request.modes.empty()) return refusal(PlanStatus::invalid_input, "no motion mode is allowed");
  if (!checker.is_free(request.start))
    return refusal(PlanStatus::start_in_collision,
                   collision_sentence("the start", request.start, disc_clearance(checker, request.start)));
  if (!checker.is_free(request.goal))
    return refusal(PlanStatus::goal_in_collision,
                   collision_sentence("the goal", request.goal, disc_clearance(checker, request.goal)));
  return refusal(PlanStatus::succeeded, "");
}

bool same_pose(const Pose& a, const Pose& b)
{
  return distance(a, b) < 1e-6 && std::abs(wrap_angle(a.theta - b.theta)) < 1e-6;
}

/// Fills the result with the first trajectory that the referee accepts, or with the last one and why not. Returns which.
std::size_t judge(const World& world, const PlanRequest& request, std::vector<Trajectory> trajectories,
                  PlanResult& result)
{
  const Clock::time_point begin = Clock::now();
  std::size_t chosen = 0;
  Verdict verdict;
  for (chosen = 0; chosen < trajectories.size(); ++chosen)
  {
    verdict = world.referee.judge(request.start, request.goal, trajectories[chosen]);
    if (verdict.accepted() || chosen + 1 == trajectories.size()) break;
  }
  result.trajectory = std::move(trajectories[chosen]);

  PlanMetrics& metrics = result.metrics;
  metrics.verify_ms = ms_since(begin);
  metrics.safe = verdict.accepted();
  metrics.min_clearance = verdict.min_clearance;
  metrics.terminal_position_error = verdict.terminal_position_error;
  metrics.terminal_yaw_error = verdict.terminal_yaw_error;
  measure(result.trajectory, world.robot, metrics);
  result.status = verdict.accepted() ? PlanStatus::succeeded : PlanStatus::verification_failed;
  result.message = verdict.accepted() ? sentence("%.2f m in %.2f s with %d mode switch%s", metrics.length,
                                                 metrics.arrival_time, metrics.switches,
                                                 metrics.switches == 1 ? "" : "es")
                                      : verdict.violations.front().what;
  return chosen;
}

/// Candidates from the fastest to the slowest.
std::vector<std::size_t> fastest_first(const std::vector<Refinement>& refined)
{
  std::vector<std::size_t> order(refined.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return arrival_time(refined[a]) < arrival_time(refined[b]);
  });
  return order;
}

/// Polishes those that may become the fastest by it.
template <typename Polish>
void polish_fastest(std::vector<Refinement>& refined, const Polish& polish)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Refinement& refinement : refined) least = std::min(least, arrival_time(refinement));
  in_parallel(refined.size(), [&](std::size_t i) {
    if (arrival_time(refined[i]) <= kWorthPolishing * least) polish(refined[i]);
  });
}

}  // namespace

World::World(const OccupancyGrid& occupancy, const Robot& robot_model, const PlannerOptions& options)
  : World(occupancy, robot_model, options, Clock::now())
{
}

World::World(const OccupancyGrid& occupancy, const Robot& robot_model, const PlannerOptions& options,
             Clock::time_point begin)
  : robot(robot_model), grid(occupancy), obstacles(occupancy, options.obstacles), rectangles(obstacles),
    referee(occupancy, options.obstacles, robot_model, options.verify), build_ms(ms_since(begin))
{
}

std::vector<Corridor> PlanTrace::corridors() const
{
  std::vector<Corridor> last;
  for (const std::vector<RefinementRound>& segment : rounds)
    if (!segment.empty()) last.push_back(segment.back().corridor);
  return last;
}

Planner::Planner(const Robot& robot, const PlannerOptions& options) : robot_(robot), options_(options) {}

PlanResult Planner::plan(const World& world, const PlanRequest& request, const Interrupt& interrupt,
                         PlanTrace* trace) const
{
  const Clock::time_point begin = Clock::now();
  const CollisionChecker checker(world.obstacles, robot_);
  PlanResult result = refuse(checker, request);
  if (result.status == PlanStatus::succeeded)
  {
    if (same_pose(request.start, request.goal))
      judge(world, request, {stay_at(request.start, request.modes)}, result);
    else
      result = find_and_refine(world, checker, request, interrupt.or_after(options_.planner_patience), trace);
  }
  result.metrics.map_ms = world.build_ms;
  result.metrics.frontend_ms += world.build_ms;
  result.metrics.total_ms = world.build_ms + ms_since(begin);
  return result;
}

PlanResult Planner::find_and_refine(const World& world, const CollisionChecker& checker, const PlanRequest& request,
                                    const Interrupt& interrupt, PlanTrace* trace) const
{
  PlanResult result;
  std::vector<Pose>* expanded = trace ? &trace->expanded : nullptr;
  const SearchOptions& search = options_.search;

  const Clock::time_point begin = Clock::now();
  const FrontEnd front_end(checker, robot_, request.start, request.goal, interrupt);
  const Candidates found =
      request.frontend_only ? find_one(front_end, search, request.modes, interrupt, expanded)
                            : find_several(front_end, robot_, search, request.modes, interrupt, expanded);
  result.metrics.expansions = found.expansions;
  result.metrics.frontend_ms = ms_since(begin);
  result.status = interrupt.cancelled() ? PlanStatus::cancelled : found.status;
  if (result.status != PlanStatus::succeeded)
  {
    result.message = search_sentence(result.status, found.expansions, request);
    return result;
  }

  const Clock::time_point refining = Clock::now();
  std::vector<Refinement> refined(request.frontend_only ? 0 : found.paths.size());
  in_parallel(refined.size(), [&](std::size_t i) {
    refined[i] = refine(checker, world.rectangles, robot_, options_.optimize, search.reference_speed, found.paths[i],
                        interrupt);
  });
  polish_fastest(refined, [&](Refinement& refinement) {
    polish(checker, world.rectangles, robot_, options_.optimize, search.reference_speed, interrupt, refinement);
  });
  result.metrics.backend_ms = ms_since(refining);
  if (interrupt.cancelled())
  {
    result.status = PlanStatus::cancelled;
    result.message = search_sentence(result.status, found.expansions, request);
    return result;
  }

  // The fastest that the referee accepts; when it accepts none, the first path with all its stops.
  const std::vector<std::size_t> order = fastest_first(refined);
  std::vector<Trajectory> trajectories;
  for (std::size_t i : order) trajectories.push_back(std::move(refined[i].trajectory));
  trajectories.push_back(stop_and_steer(found.paths.front(), robot_, search.reference_speed));
  const std::size_t chosen = judge(world, request, std::move(trajectories), result);
  result.path = found.paths[chosen < order.size() ? order[chosen] : 0];
  if (chosen < order.size())
  {
    Refinement& refinement = refined[order[chosen]];
    result.metrics.outer_iterations = refinement.outer_iterations;
    result.metrics.ipopt_iterations = refinement.solver_iterations;
    if (trace)
      for (RefinedPart& part : refinement.parts)
        trace->rounds.push_back(std::move(part.rounds));
  }
  return result;
}

}  // namespace fourwis
