#include "fourwis_navigation/search/search.h"

#include <algorithm>
#include <cmath>

#include "directed_search.h"
#include "fourwis_navigation/vehicle/kinematics.h"
#include "fourwis_navigation/vehicle/mode_traits.h"
#include "mode_curves.h"
#include "motion_cost.h"
#include "reachability.h"
#include "shortcut.h"

namespace fourwis
{
namespace
{

/// The quick search gets this many expansions in each direction before the thorough one takes over.
constexpr int kQuickExpansions = 2000;
/// How often the thorough search halves step and cell, and how many expansions it gets in each direction before it does so:
/// twice as many each time.
constexpr int kMostHalvings = 4;
constexpr int kFirstExpansions = 5000;

/// A pass of shortcuts that gains less than this share of the cost is the last.
constexpr double kLeastShortcutGain = 0.01;

/// Half the cell and half the step, with the same cost of each metre.
SearchOptions finer(SearchOptions options, const Robot& robot)
{
  options.step_time = options.primitive_length(robot) / options.v_ref(robot) / 2.0;
  options.xy_resolution = options.cell_size(robot) / 2.0;
  options.heading_resolution /= 2.0;
  options.reverse_penalty /= 2.0;
  options.lateral_reverse_penalty /= 2.0;
  options.steering_penalty /= 2.0;
  options.parallel_steering_penalty /= 2.0;
  return options;
}

/// The same path in the other direction, from exactly `start` on.
Path reversed(Path path, const Pose& start, const Robot& robot)
{
  std::reverse(path.pieces.begin(), path.pieces.end());
  path.goal = start;
  for (PathPiece& piece : path.pieces)
  {
    piece.start = path.goal;
    piece.length = -piece.length;
    path.goal = advance(robot, piece.start, piece.mode, piece.phi, piece.length);
  }
  return path;
}

SearchResult failed(PlanStatus status)
{
  SearchResult result;
  result.status = status;
  return result;
}

}  // namespace

bool may_turn(const Pose& start, const Pose& goal, const ModeSet& modes)
{
  return can_turn(modes) || std::abs(wrap_angle(goal.theta - start.theta)) <= ModeCurves::kSameHeading;
}

Search::Search(const SearchProblem& problem) : problem_(problem), forward_(std::make_unique<DirectedSearch>(problem)) {}

Search::~Search() = default;

SearchResult Search::find(const SearchOptions& options, const ModeSet& modes, Effort effort,
                          std::vector<Pose>* expanded) const
{
  check(options);
  if (problem_.interrupt.cancelled()) return failed(PlanStatus::cancelled);
  if (problem_.interrupt.timed_out()) return failed(PlanStatus::timeout);
  if (!forward_->distance().reaches_start() || !may_turn(problem_.start, problem_.goal, modes))
    return failed(PlanStatus::goal_unreachable);

  SearchResult found = effort == Effort::thorough ? find_thoroughly(options, modes, expanded)
                                                  : find_quickly(options, modes, effort, expanded);
  if (found.status == PlanStatus::succeeded && options.terminal_connection)
    found.path = shortened(options, modes, std::move(found.path));
  return found;
}

/// From the goal to the start. Out of a narrow place is easier to find than into it.
const DirectedSearch& Search::backward() const
{
  std::call_once(once_, [&] {
    backward_ = std::make_unique<DirectedSearch>(
        SearchProblem{problem_.checker, problem_.goal, problem_.start, problem_.interrupt});
  });
  return *backward_;
}

SearchResult Search::find_quickly(SearchOptions options, const ModeSet& modes, Effort effort,
                                  std::vector<Pose>* expanded) const
{
  options.max_expansions = std::min(options.max_expansions, kQuickExpansions);
  SearchResult found = forward_->quick(options, modes, expanded);
  if (found.status != PlanStatus::no_path || effort == Effort::quick || !options.terminal_connection) return found;
  const int expansions = found.expansions;
  found = backward().quick(options, modes, nullptr);
  found.expansions += expansions;
  if (found.status == PlanStatus::succeeded)
    found.path = reversed(std::move(found.path), problem_.start, problem_.checker.robot());
  return found;
}

/// Where even a body that turns in place finds no way between the points of a lattice, a proof that there is none.
bool Search::is_proven_unreachable() const
{
  return !forward_->holonomic_distance().reaches_start() &&
         !may_be_reachable(problem_, forward_->distance(), forward_->lattice_spacing());
}

SearchResult Search::find_thoroughly(SearchOptions options, const ModeSet& modes, std::vector<Pose>* expanded) const
{
  if (is_proven_unreachable()) return failed(PlanStatus::goal_unreachable);
  SearchResult found = failed(PlanStatus::no_path);
  int left = options.max_expansions, share = kFirstExpansions, expansions = 0;
  for (int k = 0; k < kMostHalvings; ++k, share *= 2)
  {
    options = finer(options, problem_.checker.robot());
    for (const bool forward : {true, false})
    {
      options.max_expansions = std::min(share, left - expansions);
      if (options.max_expansions <= 0 || (!forward && !options.terminal_connection)) continue;
      found = forward ? forward_->guided(options, modes, expanded) : backward().guided(options, modes, nullptr);
      found.expansions = expansions += found.expansions;
      if (found.status == PlanStatus::succeeded && !forward)
        found.path = reversed(std::move(found.path), problem_.start, problem_.checker.robot());
      if (found.status != PlanStatus::no_path) return found;
    }
  }
  return found;
}

Path Search::shortened(const SearchOptions& options, const ModeSet& modes, Path path) const
{
  const Robot& robot = problem_.checker.robot();
  const MotionCost cost(robot, options);
  const ModeCurves curves(robot, options, cost, modes);
  for (int pass = 0; pass < options.shortcut_passes; ++pass)
  {
    const double before = path.cost;
    path = shortcut(problem_.checker, curves, path, problem_.interrupt);
    if (path.cost > (1.0 - kLeastShortcutGain) * before) break;
  }
  return path;
}

}  // namespace fourwis
