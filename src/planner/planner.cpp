#include "fourwis_navigation/planner/planner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "back_end.h"
#include "candidates.h"
#include "endpoints.h"
#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/vehicle/body.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/mode_limits.h"
#include "goals_nearby.h"
#include "grid_frame.h"
#include "judge.h"
#include "paper_back_end.h"
#include "plan_context.h"
#include "plan_sentences.h"
#include "stop_and_steer.h"
#include "way_out.h"

namespace fourwis
{
namespace
{

/// The start, or where the way out of the obstacles that it overlaps ends.
Pose start_of(const Robot& robot, const PlanRequest& request, const std::optional<PathPiece>& way_out)
{
  if (!way_out) return request.start;
  return advance(robot, way_out->start, way_out->mode, way_out->phi, way_out->length);
}

/// Polishing makes trajectories faster by up to about this factor.
constexpr double kWorthPolishing = 1.01;

/// What a plan is about.
struct Question
{
  const World& world;
  const PlannerOptions& options;
  const PlanRequest& request;  ///< in the frame of the world's grid
  const PlanRequest& asked;    ///< the same in the map frame
  Interrupt interrupt;
  ThreadBudget& threads;
  PlanTrace* trace;
};

/// What decides which poses are free.
struct Checkers
{
  const CollisionChecker& all;   ///< for the robot
  const CollisionChecker* wide;  ///< for the same with wide curves, where it steers slowly
};

/// The same with that, from a start that is free.
struct Task
{
  Task(const Question& question, const std::optional<PathPiece>& way_out_of_obstacles, const Checkers& checkers)
    : context{question.world, question.options, checkers.all, question.interrupt, question.threads},
      wide_curves(checkers.wide),
      request(question.request),
      asked(question.asked),
      way_out(way_out_of_obstacles),
      trace(question.trace)
  {}

  PlanContext context;
  const CollisionChecker* wide_curves;
  const PlanRequest& request;
  const PlanRequest& asked;
  const std::optional<PathPiece>& way_out;  ///< of obstacles that the body overlaps at the start
  PlanTrace* trace;

  /// Where the search begins.
  Pose start() const { return start_of(context.robot(), request, way_out); }
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

/// Share of the expansions that a thorough search with wide curves may use.
constexpr double kShareOfWideCurves = 0.25;

/// The one variant that finds the paper's path, or those whose paths are worth optimising.
std::vector<SearchVariant> variants(const Task& task, Effort effort)
{
  const SearchOptions& options = task.context.options.search;
  if (task.request.frontend_only || is_paper(task.context.options)) return {{"all", task.request.modes, options}};
  return variants_by_time(task.context.robot(), options, task.request.modes, effort);
}

Candidates find_with(const Task& task, const CollisionChecker& checker, const std::vector<SearchVariant>& variants,
                     Effort effort)
{
  const Search search({checker, task.start(), task.request.goal, task.context.interrupt});
  return find_candidates(search, variants, effort, task.context.threads, task.trace ? &task.trace->expanded : nullptr);
}

/// With wide curves; the names say so.
Candidates find_wide_curves(const Task& task, Effort effort)
{
  // As with more effort: not with each choice of modes.
  std::vector<SearchVariant> wide = variants(task, Effort::both_ways);
  for (SearchVariant& variant : wide)
    variant.options.max_expansions = std::max(1, static_cast<int>(kShareOfWideCurves * variant.options.max_expansions));
  Candidates found = find_with(task, *task.wide_curves, wide, effort);
  for (Candidate& candidate : found.candidates) candidate.name += " in wide curves";
  return found;
}

/// By quick searches both with wide curves, where those matter, and with all. What takes long is tried with wide curves first.
Candidates find_any(const Task& task, Effort effort)
{
  const CollisionChecker& all = task.context.checker;
  if (!task.wide_curves) return find_with(task, all, variants(task, effort), effort);
  Candidates found = find_wide_curves(task, effort);
  if (effort == Effort::quick || found.status == PlanStatus::no_path)
    add(find_with(task, all, variants(task, effort), effort), found);
  return found;
}

/// Paths from start to goal; the result says how the search went.
std::vector<Candidate> find(const Task& task, Effort effort, PlanResult& result)
{
  const PlanClock::time_point begin = PlanClock::now();
  const PlanContext& context = task.context;
  Candidates found = find_any(task, effort);
  result.metrics.expansions += found.expansions;
  result.metrics.frontend_ms += ms_since(begin);
  result.status = context.interrupt.cancelled() ? PlanStatus::cancelled : found.status;
  if (result.status != PlanStatus::succeeded) return {};
  if (task.way_out)
    for (Candidate& candidate : found.candidates)
    {
      candidate.path.pieces.insert(candidate.path.pieces.begin(), *task.way_out);
      candidate.path.begins_with_way_out = true;
    }
  result.path = found.candidates.front().path;
  return std::move(found.candidates);
}

double arrival_time(const Refinement& refinement)
{
  return refinement.trajectory.empty() ? std::numeric_limits<double>::infinity() : refinement.trajectory.back().t;
}

/// So many are optimised at once before the others are held against the fastest of them.
constexpr std::size_t kFirst = 2;

double fastest(const std::vector<Refinement>& refined)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Refinement& refinement : refined) least = std::min(least, arrival_time(refinement));
  return least;
}

/// All paths optimised that may become the fastest, and those polished that may become it by that.
std::vector<Refinement> refine(const PlanContext& context, const std::vector<Candidate>& candidates)
{
  const BackEnd back_end(context);
  std::vector<Refinement> refined(candidates.size());
  const auto refine_one = [&](std::size_t i) { refined[i] = back_end.refine(candidates[i].path); };
  const std::size_t first = std::min(kFirst, candidates.size());
  context.threads.for_each(first, refine_one);
  double least = fastest(refined);
  context.threads.for_each(candidates.size() - first, [&](std::size_t i) {
    if (least_time(context.robot(), candidates[first + i].path) < least) refine_one(first + i);
  });
  least = fastest(refined);
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

void report(Refinement& refinement, PlanTrace* trace, PlanResult& result)
{
  result.fallback_parts = refinement.fallbacks;
  result.metrics.outer_iterations = refinement.outer_iterations;
  result.metrics.ipopt_iterations = refinement.solver_iterations;
  if (!trace) return;
  for (RefinedPart& part : refinement.parts) trace->rounds.push_back(std::move(part.rounds));
}

/// The fastest that the referee accepts; when it accepts none, the first path with all its stops.
void choose(const Task& task, const std::vector<Candidate>& candidates, std::vector<Refinement> refined,
            PlanResult& result)
{
  const PlanContext& context = task.context;
  const std::vector<std::size_t> order = fastest_first(refined);
  std::vector<Trajectory> trajectories;
  trajectories.reserve(order.size() + 1);
  for (std::size_t i : order) trajectories.push_back(std::move(refined[i].trajectory));
  trajectories.push_back(stop_and_steer(candidates.front().path, context.robot()));
  const std::size_t chosen = judge(context.world, task.request, std::move(trajectories), result);
  const bool is_refined = chosen < order.size();
  const Candidate& candidate = candidates[is_refined ? order[chosen] : 0];
  result.candidate = candidate.name;
  result.path = candidate.path;
  result.fallback_parts = task.request.frontend_only ? 0 : candidate.path.switches() + 1;
  const std::string why = is_refined ? refined[order[chosen]].message : "no candidate was accepted";
  if (is_refined) report(refined[order[chosen]], task.trace, result);
  if (result.status == PlanStatus::succeeded) result.message += remarks(result, task.request.frontend_only ? "" : why);
}

void refine_and_choose(const Task& task, const std::vector<Candidate>& candidates, PlanResult& result)
{
  const PlanClock::time_point begin = PlanClock::now();
  std::vector<Refinement> refined;
  if (!task.request.frontend_only) refined = refine(task.context, candidates);
  result.metrics.backend_ms = ms_since(begin);
  if (task.context.interrupt.cancelled())
  {
    result.status = PlanStatus::cancelled;
    result.message = search_sentence(task.context.world, result, task.asked);
    return;
  }
  result.degraded = task.context.interrupt.timed_out();
  choose(task, candidates, std::move(refined), result);
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

/// A plan between two free poses, or how the search for one ended.
void try_to_plan(const Task& task, Effort effort, PlanResult& result)
{
  const std::vector<Candidate> found = find(task, effort, result);
  if (result.status != PlanStatus::succeeded) return;
  if (is_paper(task.context.options) && !task.request.frontend_only)
    refine_as_in_paper(task, found.front().path, result);
  else
    refine_and_choose(task, found, result);
}

/// The same, and where wide curves end in a part with stops also without them: the plan that arrives first.
void try_to_plan_fast(const Question& question, const std::optional<PathPiece>& way_out, const Checkers& checkers,
                      Effort effort, PlanResult& result)
{
  try_to_plan({question, way_out, checkers}, effort, result);
  if (!checkers.wide || result.status != PlanStatus::succeeded || result.fallback_parts == 0) return;
  PlanTrace trace;
  const Question again = {question.world,
                          question.options,
                          question.request,
                          question.asked,
                          question.interrupt,
                          question.threads,
                          question.trace ? &trace : nullptr};
  PlanResult other;
  try_to_plan({again, way_out, {checkers.all, nullptr}}, effort, other);
  PlanMetrics &metrics = result.metrics, &more = other.metrics;
  const bool is_faster = other.status == PlanStatus::succeeded && more.arrival_time < metrics.arrival_time;
  for (double PlanMetrics::*time : {&PlanMetrics::frontend_ms, &PlanMetrics::backend_ms, &PlanMetrics::verify_ms})
    metrics.*time = more.*time += metrics.*time;
  metrics.expansions = more.expansions += metrics.expansions;
  if (!is_faster) return;
  result = std::move(other);
  if (question.trace) *question.trace = std::move(trace);
}

/// First as the paper does, with two discs for the body. Where they find nothing, by the body itself.
PlanResult plan_between(const Question& question, const std::optional<PathPiece>& way_out)
{
  const World& world = question.world;
  const PlanRequest& request = question.request;
  const bool paper = is_paper(question.options);
  PlanResult result;
  if (same_pose(request.start, request.goal) && !way_out)
  {
    judge(world, request, {stay_at(request.start, request.modes)}, result);
    return result;
  }
  const bool has_wide_curves = !paper && !request.frontend_only && steers_slowly(world.robot, question.options.search);
  const Robot wide = with_wide_curves(world.robot);
  const CollisionChecker two_discs(world.obstacles, world.robot), wide_two_discs(world.obstacles, wide);
  const Pose start = start_of(world.robot, request, way_out);
  result.status = PlanStatus::no_path;
  if (paper || (two_discs.is_free(start) && two_discs.is_free(request.goal)))
    try_to_plan_fast(question, way_out, {two_discs, has_wide_curves ? &wide_two_discs : nullptr},
                     paper ? Effort::thorough : Effort::quick, result);
  const bool found_nothing = result.status == PlanStatus::no_path || result.status == PlanStatus::goal_unreachable;
  if (found_nothing && !paper)
  {
    const CollisionChecker body(world.obstacles, world.robot, {start, request.goal});
    const CollisionChecker wide_body(world.obstacles, wide, {start, request.goal});
    try_to_plan_fast(question, way_out, {body, has_wide_curves ? &wide_body : nullptr}, Effort::thorough, result);
  }
  if (result.message.empty()) result.message = search_sentence(world, result, question.asked);
  return result;
}

/// What is wrong with a request whatever the map is; empty if nothing is.
std::string complaint(const Robot& robot, const PlannerOptions& options, const PlanRequest& request)
{
  const Point2 middle = box_of(robot).middle;
  if (is_paper(options) && !request.frontend_only && (middle.x != 0.0 || middle.y != 0.0))
    return "the paper's formulation takes a body whose middle is the centre of the wheels";
  if (!is_finite(request.start)) return "the start pose is not finite";
  if (!is_finite(request.goal)) return "the goal pose is not finite";
  if (!std::isfinite(request.goal_tolerance) || request.goal_tolerance < 0.0)
    return sentence("the goal's tolerance is %g m, expected a finite number from 0", request.goal_tolerance);
  if (request.modes.empty()) return "no motion mode that the wheels can do is allowed";
  return {};
}

/// Both poses judged by the body; then the plan.
PlanResult answer_exactly(const Question& question)
{
  const World& world = question.world;
  const PlanRequest &request = question.request, &asked = question.asked;
  const Endpoint start = endpoint(world, question.options, request.start),
                 goal = endpoint(world, question.options, request.goal);
  const bool may_leave = start.clearance >= -question.options.referee.start_tolerance && !start.off_map;
  std::optional<PathPiece> out;
  if (start.clearance < 0.0 && may_leave) out = way_out(world, request.start, request.modes);
  if (start.clearance < 0.0 && !out)
    return no_plan(PlanStatus::start_in_collision,
                   collision_sentence(world, start, "start", asked.start, request.start) +
                       (may_leave ? "; no motion leads out without getting deeper" : ""));
  if (goal.clearance < 0.0)
    return no_plan(PlanStatus::goal_in_collision, collision_sentence(world, goal, "goal", asked.goal, request.goal));
  PlanResult result = plan_between(question, out);
  result.overlap = std::max(0.0, -start.clearance);
  if (result.overlap > 0.0 && result.status == PlanStatus::succeeded)
    result.message += sentence("; at the start the body overlaps an obstacle by %.3f m", result.overlap);
  return result;
}

/// Whether a pose nearby may have a plan where the goal has none.
bool lies_with_the_goal(PlanStatus status)
{
  return status == PlanStatus::goal_in_collision || status == PlanStatus::goal_unreachable ||
         status == PlanStatus::no_path;
}

/// Whether there is nothing more to try: a plan, or no time.
bool is_over(PlanStatus status)
{
  return status == PlanStatus::succeeded || status == PlanStatus::timeout || status == PlanStatus::cancelled;
}

/// The goal itself; where it has no plan, the nearest pose within its tolerance that has one.
PlanResult answer(const Question& question)
{
  PlanResult result = answer_exactly(question);
  if (question.request.goal_tolerance == 0.0 || !lies_with_the_goal(result.status)) return result;
  const std::vector<Pose> goals = free_goals_nearby(question.world, question.options, question.request);
  const GridFrame frame(question.world.grid.origin, question.world.robot);
  for (const Pose& goal : goals)
  {
    PlanRequest request = question.request, asked = question.asked;
    request.goal = goal;
    asked.goal = frame.to_map(goal);
    if (question.trace) *question.trace = {};
    PlanResult nearby = answer_exactly(
        {question.world, question.options, request, asked, question.interrupt, question.threads, question.trace});
    if (!is_over(nearby.status)) continue;
    nearby.message += sentence("; for (%.3f, %.3f), %.3f m from a goal that is %s", asked.goal.x, asked.goal.y,
                               distance(goal, question.request.goal), to_string(result.status));
    return nearby;
  }
  result.message += sentence("; nor has any of the %zu free poses within %g m of it a plan", goals.size(),
                             question.request.goal_tolerance);
  return result;
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

PlanResult Planner::judge_goal(const World& world, const Pose& goal) const
{
  if (!is_finite(goal)) return no_plan(PlanStatus::invalid_input, "the goal pose is not finite");
  const Pose in_grid = GridFrame(world.grid.origin, world.robot).to_grid(goal);
  const Endpoint end = endpoint(world, options_, in_grid);
  if (end.clearance >= 0.0) return no_plan(PlanStatus::succeeded, "");
  return no_plan(PlanStatus::goal_in_collision, collision_sentence(world, end, "goal", goal, in_grid));
}

PlanResult Planner::plan(const World& world, const PlanRequest& asked, const Interrupt& interrupt,
                         PlanTrace* trace) const
{
  const PlanClock::time_point begin = PlanClock::now();
  const Interrupt watch = interrupt.or_after(options_.planner_patience);
  const GridFrame frame(world.grid.origin, world.robot);
  PlanRequest request = frame.to_grid(asked);
  request.modes = asked.modes & DriveLimits(world.robot).possible();
  PlanResult result;
  if (const std::string wrong = complaint(world.robot, options_, request); !wrong.empty())
    result = no_plan(PlanStatus::invalid_input, wrong);
  else
  {
    ThreadBudget threads(threads_);
    std::optional<World> seen;
    if (stands_on_unseen_ground(world, request.start))
      seen.emplace(with_free_ground(world.grid, world, request.start), world.robot, options_);
    result = answer({seen ? *seen : world, options_, request, asked, watch, threads, trace});
  }
  frame.to_map(result);
  if (trace) frame.to_map(*trace);
  result.metrics.map_ms = world.build_ms;
  result.metrics.frontend_ms += world.build_ms;
  result.metrics.total_ms = world.build_ms + ms_since(begin);
  return result;
}

}  // namespace fourwis
