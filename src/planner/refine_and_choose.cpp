#include "refine_and_choose.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "back_end.h"
#include "judge.h"
#include "plan_sentences.h"
#include "stop_and_steer.h"

namespace fourwis
{
namespace
{

/// Polishing makes trajectories faster by up to about this factor.
constexpr double kWorthPolishing = 1.01;

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

}  // namespace

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

}  // namespace fourwis
