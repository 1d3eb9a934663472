#include "fourwis_navigation/search/search.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "fourwis_navigation/vehicle/mode_traits.h"
#include "mode_curves.h"
#include "motion_cost.h"
#include "reachability.h"
#include "shortcut.h"

namespace fourwis
{
namespace
{

/// Beyond the first way to the start, distances to the goal are known this much further [m].
constexpr double kFieldSlack = 4.0;
/// Cells of the floods over (x, y, theta) [m], and how many there may be: 64 bytes each.
constexpr double kFloodCell = 0.05;
constexpr double kMostFloodCells = 1e6;
/// The quick search gets this many expansions before the thorough one takes over.
constexpr int kQuickExpansions = 2000;
/// How often the thorough search halves step and cell, each time it has seen everything at the resolution before.
constexpr int kMostHalvings = 4;

/// A pass of shortcuts that gains less than this share of the cost is the last.
constexpr double kLeastShortcutGain = 0.01;

/// Half the cell and half the step, with the same cost of each metre.
SearchOptions finer(SearchOptions options)
{
  options.step_time /= 2.0;
  options.xy_resolution /= 2.0;
  options.heading_resolution /= 2.0;
  options.reverse_penalty /= 2.0;
  options.lateral_reverse_penalty /= 2.0;
  options.steering_penalty /= 2.0;
  options.parallel_steering_penalty /= 2.0;
  return options;
}

double flood_cell(const ObstacleMap& map)
{
  const double area = map.width() * map.resolution() * map.height() * map.resolution();
  return std::max(kFloodCell, std::sqrt(area / kMostFloodCells));
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

Search::Search(const SearchProblem& problem)
  : problem_(problem),
    distance_(problem_, kFieldSlack),
    may_be_reachable_(distance_.reaches_start() &&
                      may_be_reachable(problem_, distance_, flood_cell(problem_.checker.map()), Proof::quick))
{}

SearchResult Search::find(const SearchOptions& options, const ModeSet& modes, Effort effort,
                          std::vector<Pose>* expanded) const
{
  if (problem_.interrupt.cancelled()) return failed(PlanStatus::cancelled);
  if (problem_.interrupt.timed_out()) return failed(PlanStatus::timeout);
  if (!may_be_reachable_ || !may_turn(problem_.start, problem_.goal, modes))
    return failed(PlanStatus::goal_unreachable);

  SearchOptions quick = options;
  quick.max_expansions = std::min(options.max_expansions, kQuickExpansions);
  const auto around = [&](const Pose& pose) { return distance_(pose.x, pose.y); };
  SearchResult found = hybrid_astar(problem_, quick, modes, around, expanded);
  if (found.status == PlanStatus::no_path && effort == Effort::thorough)
  {
    SearchOptions rest = options;
    rest.max_expansions -= found.expansions;
    const int expansions = found.expansions;
    found = find_thoroughly(rest, modes, expanded);
    found.expansions += expansions;
  }
  if (found.status == PlanStatus::succeeded && options.terminal_connection)
    found.path = shortened(options, modes, std::move(found.path));
  return found;
}

/// A sharper proof than the one before the quick search. If there is none, the result guides the thorough search.
void Search::look_closer() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (proven_unreachable_ || holonomic_distance_) return;
  const double cell = flood_cell(problem_.checker.map());
  proven_unreachable_ = !may_be_reachable(problem_, distance_, cell, Proof::sharp);
  if (!proven_unreachable_) holonomic_distance_ = std::make_unique<HolonomicDistance>(problem_, cell, kFieldSlack);
}

SearchResult Search::find_thoroughly(const SearchOptions& options, const ModeSet& modes,
                                     std::vector<Pose>* expanded) const
{
  look_closer();
  if (problem_.interrupt.cancelled()) return failed(PlanStatus::cancelled);
  if (problem_.interrupt.timed_out()) return failed(PlanStatus::timeout);
  if (proven_unreachable_ || !holonomic_distance_->reaches_start()) return failed(PlanStatus::goal_unreachable);
  SearchOptions halved = options;
  SearchResult found = failed(PlanStatus::no_path);
  for (int k = 0; k < kMostHalvings && found.status == PlanStatus::no_path && halved.max_expansions > 0; ++k)
  {
    halved = finer(halved);
    const int before = found.expansions;
    found = hybrid_astar(problem_, halved, modes, std::cref(*holonomic_distance_), expanded);
    halved.max_expansions -= found.expansions;
    found.expansions += before;
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
