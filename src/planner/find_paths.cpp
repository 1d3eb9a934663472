#include "find_paths.h"

#include <algorithm>
#include <utility>

#include "judge.h"

namespace fourwis
{
namespace
{

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

}  // namespace

std::vector<Candidate> find_paths(const Task& task, Effort effort, PlanResult& result)
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

}  // namespace fourwis
