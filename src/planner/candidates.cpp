#include "candidates.h"

#include <algorithm>

namespace fourwis
{
namespace
{

/// Share of the penalties of steering and reversing that the softened costs keep.
constexpr double kSoftened = 0.2;

/// Costs that stand for time: a share of the penalties, and the stop at each change of direction.
SearchOptions time_costs(const Robot& robot, SearchOptions options, double share)
{
  const double stop = options.reference_speed * options.reference_speed / robot.max_acceleration;
  options.reverse_penalty *= share;
  options.lateral_reverse_penalty *= share;
  options.steering_penalty *= share;
  options.parallel_steering_penalty *= share;
  options.steering_change_penalty *= share;
  options.direction_change_penalty = stop + share * options.direction_change_penalty;
  return options;
}

bool same_path(const Path& a, const Path& b)
{
  const auto same_piece = [](const PathPiece& p, const PathPiece& q) {
    return p.mode == q.mode && p.phi == q.phi && p.length == q.length;
  };
  return std::equal(a.pieces.begin(), a.pieces.end(), b.pieces.begin(), b.pieces.end(), same_piece);
}

Candidates collect(const std::vector<SearchResult>& results)
{
  Candidates candidates;
  candidates.status = results.front().status;
  for (const SearchResult& result : results)
  {
    candidates.expansions += result.expansions;
    if (result.status != PlanStatus::succeeded) continue;
    candidates.status = PlanStatus::succeeded;
    const auto known = [&](const Path& path) { return same_path(path, result.path); };
    if (std::none_of(candidates.paths.begin(), candidates.paths.end(), known)) candidates.paths.push_back(result.path);
  }
  return candidates;
}

}  // namespace

std::vector<SearchVariant> variants_by_time(const Robot& robot, const SearchOptions& options, const ModeSet& modes)
{
  const ModeSet car = {kCarMode};
  std::vector<SearchVariant> variants = {{modes, time_costs(robot, options, 0.0), Effort::thorough}};
  if (modes.contains(kCarMode) && modes != car)
    variants.push_back({car, time_costs(robot, options, 0.0), Effort::quick});
  if (modes.contains(kCarMode)) variants.push_back({car, time_costs(robot, options, kSoftened), Effort::quick});
  return variants;
}

Candidates find_candidates(const Search& search, const std::vector<SearchVariant>& variants, ThreadBudget& threads,
                           std::vector<Pose>* expanded)
{
  std::vector<SearchResult> results(variants.size());
  threads.for_each(variants.size(), [&](std::size_t i) {
    const SearchVariant& variant = variants[i];
    results[i] = search.find(variant.options, variant.modes, variant.effort, i == 0 ? expanded : nullptr);
  });
  return collect(results);
}

}  // namespace fourwis
