#include "candidates.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace fourwis
{
namespace
{

/// Share of the greatest curvature that wide curves have, and the least steering angle at all, as of a robot [rad].
constexpr double kWideCurves = 0.7, kLeastSteering = 0.01;
/// After so many a search with few modes gives up.
constexpr int kBriefExpansions = 100;
/// Share of the penalties of steering and reversing that the softened costs keep.
constexpr double kSoftened = 0.2;

/// Costs that stand for time: a share of the penalties, and the stop at each change of direction. They stay within the ranges
/// of SearchOptions: the longest stop, from 20 m/s at 0.01 m/s^2, costs 40 km, and direction_change_penalty may be 100 km.
SearchOptions time_costs(const Robot& robot, SearchOptions options, double share)
{
  const double v_ref = options.v_ref(robot), stop = v_ref * v_ref / robot.max_acceleration;
  options.reverse_penalty *= share;
  options.lateral_reverse_penalty *= share;
  options.steering_penalty *= share;
  options.parallel_steering_penalty *= share;
  options.steering_change_penalty *= share;
  options.direction_change_penalty = stop + share * options.direction_change_penalty;
  return options;
}

/// Those that have some of the modes, the fewest first.
std::vector<ModeSet> choices_of(const ModeSet& modes)
{
  std::vector<ModeSet> choices;
  for (std::size_t count = 1; count <= kPlannedModes.size(); ++count)
    for (unsigned bits = 1; bits < 1u << kPlannedModes.size(); ++bits)
    {
      ModeSet choice = ModeSet::none();
      std::size_t size = 0;
      for (std::size_t k = 0; k < kPlannedModes.size(); ++k)
        if (bits >> k & 1u)
        {
          choice.insert(kPlannedModes[k]);
          ++size;
        }
      if (size == count && (choice & modes) == choice) choices.push_back(choice);
    }
  return choices;
}

std::string names_of(const ModeSet& modes)
{
  std::string names;
  for (Mode mode : kPlannedModes)
    if (modes.contains(mode)) names += (names.empty() ? "" : " and ") + std::string(to_string(mode));
  return names;
}

/// From rest to rest over a way [s].
double least_time_over(const Robot& robot, double way)
{
  const double ramp = robot.max_speed * robot.max_speed / robot.max_acceleration;
  if (way < ramp) return 2.0 * std::sqrt(way / robot.max_acceleration);
  return way / robot.max_speed + robot.max_speed / robot.max_acceleration;
}

bool same_path(const Path& a, const Path& b)
{
  const auto same_piece = [](const PathPiece& p, const PathPiece& q) {
    return p.mode == q.mode && p.phi == q.phi && p.length == q.length;
  };
  return std::equal(a.pieces.begin(), a.pieces.end(), b.pieces.begin(), b.pieces.end(), same_piece);
}

Candidates collect(const std::vector<SearchVariant>& variants, const std::vector<SearchResult>& results)
{
  Candidates found;
  found.status = results.front().status;
  for (std::size_t i = 0; i < results.size(); ++i)
  {
    const SearchResult& result = results[i];
    found.expansions += result.expansions;
    if (result.status != PlanStatus::succeeded) continue;
    found.status = PlanStatus::succeeded;
    const auto known = [&](const Candidate& candidate) { return same_path(candidate.path, result.path); };
    if (std::none_of(found.candidates.begin(), found.candidates.end(), known))
      found.candidates.push_back({variants[i].name, result.path});
  }
  return found;
}

}  // namespace

std::vector<SearchVariant> variants_by_time(const Robot& robot, const SearchOptions& options, const ModeSet& modes,
                                            Effort effort)
{
  const ModeSet car = {kCarMode};
  const SearchOptions by_time = time_costs(robot, options, 0.0);
  std::vector<SearchVariant> variants = {{"all modes by time", modes, by_time}};
  if (modes.contains(kCarMode) && modes != car) variants.push_back({"ackermann by time", car, by_time});
  if (modes.contains(kCarMode)) variants.push_back({"ackermann softened", car, time_costs(robot, options, kSoftened)});
  if (effort != Effort::quick) return variants;
  SearchOptions brief = by_time;
  brief.max_expansions = std::min(brief.max_expansions, kBriefExpansions);
  for (const ModeSet& fewer : choices_of(modes))
    if (fewer != modes && fewer != car) variants.push_back({names_of(fewer) + " by time", fewer, brief});
  return variants;
}

double least_time(const Robot& robot, const Path& path)
{
  double time = 0.0;
  const PathPiece* begin = nullptr;
  for (const PathPiece& piece : path.pieces)
  {
    if (begin && begin->mode == piece.mode) continue;
    if (begin) time += least_time_over(robot, distance(begin->start, piece.start)) + robot.mode_switch_time;
    begin = &piece;
  }
  return begin ? time + least_time_over(robot, distance(begin->start, path.goal)) : time;
}

bool steers_slowly(const Robot& robot, const SearchOptions& options)
{
  return options.v_ref(robot) * 2.0 * robot.max_steering_angle / robot.max_steering_rate > robot.motion_size();
}

Robot with_wide_curves(Robot robot)
{
  const double angle = std::atan(kWideCurves * std::tan(robot.max_steering_angle));
  robot.max_steering_angle = std::min(robot.max_steering_angle, std::max(kLeastSteering, angle));
  return robot;
}

void add(Candidates&& more, Candidates& found)
{
  if (found.status != PlanStatus::succeeded) found.status = more.status;
  found.expansions += more.expansions;
  std::move(more.candidates.begin(), more.candidates.end(), std::back_inserter(found.candidates));
}

Candidates find_candidates(const Search& search, const std::vector<SearchVariant>& variants, Effort effort,
                           ThreadBudget& threads, std::vector<Pose>* expanded)
{
  std::vector<SearchResult> results(variants.size());
  const auto search_with = [&](std::size_t i, Effort e) {
    const int before = results[i].expansions;
    results[i] = search.find(variants[i].options, variants[i].modes, e, i == 0 ? expanded : nullptr);
    results[i].expansions += before;
  };
  if (effort == Effort::quick)
    threads.for_each(variants.size(), [&](std::size_t i) { search_with(i, effort); });
  else
  {
    // In narrow places most searches find nothing: the others follow where the first has found something soon.
    search_with(0, Effort::both_ways);
    if (results[0].status == PlanStatus::succeeded)
      threads.for_each(variants.size() - 1, [&](std::size_t i) { search_with(i + 1, Effort::both_ways); });
    else if (results[0].status == PlanStatus::no_path)
      search_with(0, effort);
  }
  return collect(variants, results);
}

}  // namespace fourwis
