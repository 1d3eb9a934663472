#include "fourwis_navigation/planner/planner.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "candidates.h"
#include "endpoints.h"
#include "find_paths.h"
#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/vehicle/body.h"
#include "fourwis_navigation/vehicle/mode_limits.h"
#include "goals_nearby.h"
#include "grid_frame.h"
#include "judge.h"
#include "paper_back_end.h"
#include "plan_sentences.h"
#include "planning_task.h"
#include "refine_and_choose.h"
#include "way_out.h"

namespace fourwis
{
namespace
{

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
  const std::vector<Candidate> found = find_paths(task, effort, result);
  if (result.status != PlanStatus::succeeded) return;
  if (is_paper(task.context.options) && !task.request.frontend_only)
    refine_as_in_paper(task, found.front().path, result);
  else
    refine_and_choose(task, found, result);
}

/// The same, and where a thorough search ends in wide curves with a part with stops also without them: the plan that arrives
/// first. Quick searches have tried both.
void try_to_plan_fast(const Question& question, const std::optional<PathPiece>& way_out, const Checkers& checkers,
                      Effort effort, PlanResult& result)
{
  try_to_plan({question, way_out, checkers}, effort, result);
  const bool has_stops = result.status == PlanStatus::succeeded && result.fallback_parts > 0;
  if (!checkers.wide || effort == Effort::quick || !has_stops) return;
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
  std::optional<Robot> wide;
  if (!paper && !request.frontend_only && steers_slowly(world.robot, question.options.search))
    wide = with_wide_curves(world.robot);
  const CollisionChecker two_discs(world.obstacles, world.robot);
  std::optional<CollisionChecker> wide_checker;
  if (wide) wide_checker.emplace(world.obstacles, *wide);
  const Pose start = start_of(world.robot, request, way_out);
  result.status = PlanStatus::no_path;
  if (paper || (two_discs.is_free(start) && two_discs.is_free(request.goal)))
    try_to_plan_fast(question, way_out, {two_discs, wide ? &*wide_checker : nullptr},
                     paper ? Effort::thorough : Effort::quick, result);
  const bool found_nothing = result.status == PlanStatus::no_path || result.status == PlanStatus::goal_unreachable;
  if (found_nothing && !paper)
  {
    const CollisionChecker body(world.obstacles, world.robot, {start, request.goal});
    if (wide) wide_checker.emplace(world.obstacles, *wide, std::vector<Pose>{start, request.goal});
    try_to_plan_fast(question, way_out, {body, wide ? &*wide_checker : nullptr}, Effort::thorough, result);
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
