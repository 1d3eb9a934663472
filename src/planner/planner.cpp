#include "fourwis_navigation/planner/planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "back_end.h"
#include "candidates.h"
#include "fourwis_navigation/model/option_check.h"
#include "judge.h"
#include "paper_back_end.h"
#include "plan_context.h"
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
  PlanContext context;
  const PlanRequest& request;
  PlanTrace* trace;
};

bool is_paper(const PlannerOptions& options)
{
  return options.optimize.formulation == Formulation::paper;
}

bool same_pose(const Pose& a, const Pose& b)
{
  return distance(a, b) < 1e-6 && std::abs(wrap_angle(a.theta - b.theta)) < 1e-6;
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

/// The one variant that finds the paper's path, or those whose paths are worth optimising.
std::vector<SearchVariant> variants(const Task& task)
{
  const SearchOptions& options = task.context.options.search;
  if (task.request.frontend_only || is_paper(task.context.options)) return {{task.request.modes, options}};
  return variants_by_time(task.context.robot(), options, task.request.modes);
}

/// Paths from start to goal; the result says how the search went.
std::vector<Path> find(const Task& task, PlanResult& result)
{
  const PlanClock::time_point begin = PlanClock::now();
  const PlanContext& context = task.context;
  const Search search({context.checker, task.request.start, task.request.goal, context.interrupt});
  Candidates found =
      find_candidates(search, variants(task), context.threads, task.trace ? &task.trace->expanded : nullptr);
  result.metrics.expansions = found.expansions;
  result.metrics.frontend_ms = ms_since(begin);
  result.status = context.interrupt.cancelled() ? PlanStatus::cancelled : found.status;
  if (result.status != PlanStatus::succeeded)
    result.message = search_sentence(result.status, found.expansions, task.request);
  else
    result.path = found.paths.front();
  return std::move(found.paths);
}

double arrival_time(const Refinement& refinement)
{
  return refinement.trajectory.empty() ? std::numeric_limits<double>::infinity() : refinement.trajectory.back().t;
}

/// All paths optimised, and those polished that may become the fastest by it.
std::vector<Refinement> refine(const PlanContext& context, const std::vector<Path>& paths)
{
  const BackEnd back_end(context);
  std::vector<Refinement> refined(paths.size());
  context.threads.for_each(refined.size(), [&](std::size_t i) { refined[i] = back_end.refine(paths[i]); });
  double least = std::numeric_limits<double>::infinity();
  for (const Refinement& refinement : refined) least = std::min(least, arrival_time(refinement));
  context.threads.for_each(refined.size(), [&](std::size_t i) {
    if (arrival_time(refined[i]) <= kWorthPolishing * least) back_end.polish(refined[i]);
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
  const PlanContext& context = task.context;
  const std::vector<std::size_t> order = fastest_first(refined);
  std::vector<Trajectory> trajectories;
  for (std::size_t i : order) trajectories.push_back(std::move(refined[i].trajectory));
  trajectories.push_back(stop_and_steer(paths.front(), context.robot(), context.reference_speed()));
  const std::size_t chosen = judge(context.world, task.request, std::move(trajectories), result);
  if (chosen == order.size()) return;
  result.path = paths[order[chosen]];
  report(refined[order[chosen]], task.trace, result.metrics);
}

void refine_and_choose(const Task& task, const std::vector<Path>& paths, PlanResult& result)
{
  const PlanClock::time_point begin = PlanClock::now();
  std::vector<Refinement> refined;
  if (!task.request.frontend_only) refined = refine(task.context, paths);
  result.metrics.backend_ms = ms_since(begin);
  if (task.context.interrupt.cancelled())
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
void refine_as_in_paper(const Task& task, const Path& path, PlanResult& result)
{
  const PlanClock::time_point begin = PlanClock::now();
  PaperRefinement refinement = PaperBackEnd(task.context).refine(path);
  result.metrics.backend_ms = ms_since(begin);
  result.metrics.outer_iterations = refinement.outer_iterations;
  result.metrics.ipopt_iterations = refinement.ipopt_iterations;
  result.status = status_of(refinement, task.context.interrupt);
  result.message = "the paper's back end: " + refinement.message;
  if (result.status == PlanStatus::succeeded)
    judge(task.context.world, task.request, {std::move(refinement.trajectory)}, result);
}

/// The whole way from a request to a verified trajectory.
PlanResult try_to_plan(const Task& task)
{
  const PlanRequest& request = task.request;
  PlanResult result = check_request(task.context.checker, request);
  if (result.status != PlanStatus::succeeded) return result;
  if (same_pose(request.start, request.goal))
  {
    judge(task.context.world, request, {stay_at(request.start, request.modes)}, result);
    return result;
  }
  const std::vector<Path> paths = find(task, result);
  if (result.status != PlanStatus::succeeded) return result;
  if (is_paper(task.context.options) && !request.frontend_only)
    refine_as_in_paper(task, paths.front(), result);
  else
    refine_and_choose(task, paths, result);
  return result;
}

/// Whether the two discs may be what is in the way.
bool is_too_tight(const PlanResult& result)
{
  return result.status == PlanStatus::start_in_collision || result.status == PlanStatus::goal_in_collision ||
         result.status == PlanStatus::goal_unreachable || result.status == PlanStatus::no_path;
}

}  // namespace

void check(const PlannerOptions& options)
{
  check_ranges(options);
  if (is_paper(options) && !has_ipopt())
    reject_option("formulation", "'paper'", "'default': this program was built without Ipopt");
  if (options.optimize.solver == NlpSolver::ipopt && !has_ipopt())
    reject_option("solver", "'ipopt'", "'structured': this program was built without Ipopt");
  if (is_paper(options) && options.optimize.solver != NlpSolver::ipopt)
    reject_option("solver", "'structured'",
                  "'ipopt' where 'formulation' is 'paper': the structured solver has no penalties");
}

Planner::Planner(const PlannerOptions& options) : Planner(options, hardware_threads()) {}

Planner::Planner(const PlannerOptions& options, int threads) : options_(options), threads_(threads)
{
  check(options_);
  const ThreadBudget usable(threads_);  // or it throws
}

PlanResult Planner::plan(const World& world, const PlanRequest& request, const Interrupt& interrupt,
                         PlanTrace* trace) const
{
  const PlanClock::time_point begin = PlanClock::now();
  const Interrupt watch = interrupt.or_after(options_.planner_patience);
  ThreadBudget threads(threads_);
  const CollisionChecker two_discs(world.obstacles, world.robot);
  PlanResult result = try_to_plan({{world, options_, two_discs, watch, threads}, request, trace});
  if (is_too_tight(result) && !is_paper(options_))
  {
    const PlanMetrics before = result.metrics;
    const CollisionChecker close(world.obstacles, world.robot, {request.start, request.goal});
    result = try_to_plan({{world, options_, close, watch, threads}, request, trace});
    result.metrics.frontend_ms += before.frontend_ms;
    result.metrics.expansions += before.expansions;
  }
  result.metrics.map_ms = world.build_ms;
  result.metrics.frontend_ms += world.build_ms;
  result.metrics.total_ms = world.build_ms + ms_since(begin);
  return result;
}

}  // namespace fourwis
