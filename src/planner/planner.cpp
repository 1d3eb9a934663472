#include "fourwis_navigation/planner/planner.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "back_end.h"
#include "candidates.h"
#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/search/front_end.h"
#include "in_parallel.h"
#include "judge.h"
#include "paper_back_end.h"
#include "plan_sentences.h"
#include "stop_and_steer.h"

namespace fourwis
{
namespace
{

/// Polishing makes trajectories faster by up to about this factor.
constexpr double kWorthPolishing = 1.01;

/// What a plan is about.
struct Task
{
  const World& world;
  const PlannerOptions& options;
  const PlanRequest& request;
  const Interrupt& interrupt;
  PlanTrace* trace;
  CollisionChecker checker;

  double speed() const { return options.search.reference_speed; }
};

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

bool is_paper(const PlannerOptions& options)
{
  return options.optimize.formulation == Formulation::paper;
}

/// The paths worth optimising; the result says how the search went.
Candidates find(const Task& task, PlanResult& result)
{
  const PlanClock::time_point begin = PlanClock::now();
  const PlanRequest& request = task.request;
  std::vector<Pose>* expanded = task.trace ? &task.trace->expanded : nullptr;
  const FrontEnd front_end(task.checker, task.world.robot, request.start, request.goal, task.interrupt);
  Candidates found =
      request.frontend_only || is_paper(task.options)
          ? find_one(front_end, task.options.search, request.modes, task.interrupt, expanded)
          : find_several(front_end, task.world.robot, task.options.search, request.modes, task.interrupt, expanded);
  result.metrics.expansions = found.expansions;
  result.metrics.frontend_ms = ms_since(begin);
  result.status = task.interrupt.cancelled() ? PlanStatus::cancelled : found.status;
  if (result.status != PlanStatus::succeeded)
    result.message = search_sentence(result.status, found.expansions, request);
  else
    result.path = found.paths.front();
  return found;
}

double arrival_time(const Refinement& refinement)
{
  return refinement.trajectory.empty() ? std::numeric_limits<double>::infinity() : refinement.trajectory.back().t;
}

/// All paths optimised, and those polished that may become the fastest by it.
std::vector<Refinement> refine_all(const Task& task, const std::vector<Path>& paths)
{
  const World& world = task.world;
  const OptimizeOptions& options = task.options.optimize;
  std::vector<Refinement> refined(paths.size());
  in_parallel(refined.size(), [&](std::size_t i) {
    refined[i] = refine(task.checker, world.rectangles, world.robot, options, task.speed(), paths[i], task.interrupt);
  });
  double least = std::numeric_limits<double>::infinity();
  for (const Refinement& refinement : refined) least = std::min(least, arrival_time(refinement));
  in_parallel(refined.size(), [&](std::size_t i) {
    if (arrival_time(refined[i]) <= kWorthPolishing * least)
      polish(task.checker, world.rectangles, world.robot, options, task.speed(), task.interrupt, refined[i]);
  });
  return refined;
}

/// From the fastest to the slowest.
std::vector<std::size_t> fastest_first(const std::vector<Refinement>& refined)
{
  std::vector<std::size_t> order(refined.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return arrival_time(refined[a]) < arrival_time(refined[b]); });
  return order;
}

void report(Refinement& refinement, PlanTrace* trace, PlanMetrics& metrics)
{
  metrics.outer_iterations = refinement.outer_iterations;
  metrics.ipopt_iterations = refinement.solver_iterations;
  if (!trace) return;
  for (RefinedPart& part : refinement.parts) trace->rounds.push_back(std::move(part.rounds));
}

/// The fastest that the referee accepts; when it accepts none, the first path with all its stops.
void choose(const Task& task, const std::vector<Path>& paths, std::vector<Refinement> refined, PlanResult& result)
{
  const std::vector<std::size_t> order = fastest_first(refined);
  std::vector<Trajectory> trajectories;
  for (std::size_t i : order) trajectories.push_back(std::move(refined[i].trajectory));
  trajectories.push_back(stop_and_steer(paths.front(), task.world.robot, task.speed()));
  const std::size_t chosen = judge(task.world, task.request, std::move(trajectories), result);
  if (chosen == order.size()) return;
  result.path = paths[order[chosen]];
  report(refined[order[chosen]], task.trace, result.metrics);
}

void refine_and_choose(const Task& task, const std::vector<Path>& paths, PlanResult& result)
{
  const PlanClock::time_point begin = PlanClock::now();
  std::vector<Refinement> refined;
  if (!task.request.frontend_only) refined = refine_all(task, paths);
  result.metrics.backend_ms = ms_since(begin);
  if (task.interrupt.cancelled())
  {
    result.status = PlanStatus::cancelled;
    result.message = search_sentence(result.status, result.metrics.expansions, task.request);
    return;
  }
  choose(task, paths, std::move(refined), result);
}

PlanStatus status_of(const PaperRefinement& refinement, const Interrupt& interrupt)
{
  if (refinement.status == PaperStatus::converged) return PlanStatus::succeeded;
  if (refinement.status != PaperStatus::interrupted) return PlanStatus::not_converged;
  return interrupt.cancelled() ? PlanStatus::cancelled : PlanStatus::timeout;
}

/// The paper's back end: what it makes of the one path is the answer if the referee accepts it, and there is no other.
void refine_as_paper(const Task& task, const Path& path, PlanResult& result)
{
  const PlanClock::time_point begin = PlanClock::now();
  PaperRefinement refinement = refine_as_in_paper(task.world.rectangles, task.world.robot, PaperBackEndOptions(),
                                                  task.speed(), path, task.interrupt);
  result.metrics.backend_ms = ms_since(begin);
  result.metrics.outer_iterations = refinement.outer_iterations;
  result.metrics.ipopt_iterations = refinement.ipopt_iterations;
  result.status = status_of(refinement, task.interrupt);
  result.message = "the paper's back end: " + refinement.message;
  if (result.status == PlanStatus::succeeded)
    judge(task.world, task.request, {std::move(refinement.trajectory)}, result);
}

/// Whether the two discs may be what is in the way.
bool is_too_tight(const PlanResult& result)
{
  return result.status == PlanStatus::start_in_collision || result.status == PlanStatus::goal_in_collision ||
         result.status == PlanStatus::goal_unreachable || result.status == PlanStatus::no_path;
}

PlanResult find_and_refine(const Task& task)
{
  PlanResult result;
  const Candidates found = find(task, result);
  if (result.status != PlanStatus::succeeded) return result;
  if (is_paper(task.options) && !task.request.frontend_only)
    refine_as_paper(task, found.paths.front(), result);
  else
    refine_and_choose(task, found.paths, result);
  return result;
}

PlanResult try_to_plan(const Task& task)
{
  const PlanRequest& request = task.request;
  PlanResult result = check_request(task.checker, request);
  if (result.status != PlanStatus::succeeded) return result;
  if (!same_pose(request.start, request.goal)) return find_and_refine(task);
  judge(task.world, request, {stay_at(request.start, request.modes)}, result);
  return result;
}

}  // namespace

World::World(const OccupancyGrid& occupancy, const Robot& robot_model, const PlannerOptions& options)
  : World(occupancy, robot_model, options, PlanClock::now())
{}

World::World(const OccupancyGrid& occupancy, const Robot& robot_model, const PlannerOptions& options,
             PlanClock::time_point begin)
  : robot(robot_model),
    grid(occupancy),
    obstacles(occupancy, options.obstacles),
    rectangles(obstacles),
    referee(occupancy, options.obstacles, robot_model, options.referee),
    build_ms(ms_since(begin))
{}

std::vector<Corridor> PlanTrace::corridors() const
{
  std::vector<Corridor> last;
  for (const std::vector<RefinementRound>& segment : rounds)
    if (!segment.empty()) last.push_back(segment.back().corridor);
  return last;
}

std::vector<Corridor> PlanTrace::all_corridors() const
{
  std::vector<Corridor> all;
  for (const std::vector<RefinementRound>& segment : rounds)
    for (const RefinementRound& round : segment) all.push_back(round.corridor);
  return all;
}

std::vector<Trajectory> PlanTrace::iterations() const
{
  std::vector<Trajectory> all;
  for (const std::vector<RefinementRound>& segment : rounds)
    for (std::size_t i = 0; i + 1 < segment.size(); ++i) all.push_back(segment[i].points);
  return all;
}

void check(const PlannerOptions& options)
{
  if (is_paper(options) && options.optimize.solver != NlpSolver::ipopt)
    throw std::invalid_argument(
        "parameter 'solver' is 'structured', expected 'ipopt' where 'formulation' is 'paper': "
        "the structured solver has no penalties");
}

Planner::Planner(const Robot& robot, const PlannerOptions& options) : robot_(robot), options_(options)
{
  check(options);
}

PlanResult Planner::plan(const World& world, const PlanRequest& request, const Interrupt& interrupt,
                         PlanTrace* trace) const
{
  const PlanClock::time_point begin = PlanClock::now();
  const Interrupt watch = interrupt.or_after(options_.planner_patience);
  PlanResult result = try_to_plan({world, options_, request, watch, trace, {world.obstacles, world.robot}});
  if (is_too_tight(result) && !is_paper(options_))
  {
    const PlanMetrics before = result.metrics;
    const CollisionChecker close(world.obstacles, world.robot, {request.start, request.goal});
    result = try_to_plan({world, options_, request, watch, trace, close});
    result.metrics.frontend_ms += before.frontend_ms;
    result.metrics.expansions += before.expansions;
  }
  result.metrics.map_ms = world.build_ms;
  result.metrics.frontend_ms += world.build_ms;
  result.metrics.total_ms = world.build_ms + ms_since(begin);
  return result;
}

}  // namespace fourwis
