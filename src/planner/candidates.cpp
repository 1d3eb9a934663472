#include "candidates.h"

#include <algorithm>

#include "in_parallel.h"

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

struct Wish
{
  ModeSet modes;
  SearchOptions options;
  Effort effort;
};

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

Candidates find_one(const FrontEnd& front_end, const SearchOptions& options, const ModeSet& modes,
                    const Interrupt& interrupt, std::vector<Pose>* expanded)
{
  return collect({front_end.find(options, modes, Effort::thorough, interrupt, expanded)});
}

Candidates find_several(const FrontEnd& front_end, const Robot& robot, const SearchOptions& options,
                        const ModeSet& modes, const Interrupt& interrupt, std::vector<Pose>* expanded)
{
  const ModeSet car = {kCarMode};
  std::vector<Wish> wishes = {{modes, time_costs(robot, options, 0.0), Effort::thorough}};
  if (modes.contains(kCarMode) && modes != car) wishes.push_back({car, time_costs(robot, options, 0.0), Effort::quick});
  if (modes.contains(kCarMode)) wishes.push_back({car, time_costs(robot, options, kSoftened), Effort::quick});

  std::vector<SearchResult> results(wishes.size());
  in_parallel(wishes.size(), [&](std::size_t i) {
    results[i] =
        front_end.find(wishes[i].options, wishes[i].modes, wishes[i].effort, interrupt, i == 0 ? expanded : nullptr);
  });
  return collect(results);
}

}  // namespace fourwis
