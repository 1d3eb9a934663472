#include "fourwis_navigation/search/front_end.h"

#include <algorithm>

#include "fourwis_navigation/search/goal_distance.h"
#include "fourwis_navigation/search/mode_curves.h"
#include "fourwis_navigation/search/motion_cost.h"
#include "fourwis_navigation/search/reachability.h"
#include "fourwis_navigation/search/shortcut.h"

namespace fourwis
{
namespace
{

/// Beyond the first way to the start, the goal distance is known this much further [m].
constexpr double kFieldSlack = 4.0;
/// The coarse search gets this share of all expansions before a finer one takes over.
constexpr double kCoarseShare = 0.1;

/// Half the cell, half the step: for places where the default finds no way.
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

/// First coarse, then fine.
SearchResult search(const CollisionChecker& checker, const Robot& robot, const SearchOptions& options,
                    const PlanRequest& request, const GoalDistance& distance, const Interrupt& interrupt,
                    std::vector<Pose>* expanded)
{
  SearchOptions coarse = options, fine = finer(options);
  coarse.max_expansions = static_cast<int>(kCoarseShare * options.max_expansions);
  const SearchResult quick = hybrid_astar(checker, robot, coarse, request, distance, interrupt, expanded);
  if (quick.status != PlanStatus::no_path) return quick;
  fine.max_expansions = options.max_expansions - quick.expansions;
  SearchResult thorough = hybrid_astar(checker, robot, fine, request, distance, interrupt, expanded);
  thorough.expansions += quick.expansions;
  return thorough;
}

Path shortened(const CollisionChecker& checker, const Robot& robot, const SearchOptions& options,
               const PlanRequest& request, Path path, const Interrupt& interrupt)
{
  const MotionCost cost(robot, options);
  const ModeCurves curves(robot, options, cost, request.modes);
  for (int pass = 0; pass < options.shortcut_passes; ++pass)
    path = shortcut(checker, curves, cost, path, request.modes.first(), interrupt);
  return path;
}

SearchResult failed(PlanStatus status)
{
  SearchResult result;
  result.status = status;
  return result;
}

}  // namespace

SearchResult find_path(const CollisionChecker& checker, const Robot& robot, const SearchOptions& options,
                       const PlanRequest& request, const Interrupt& interrupt, std::vector<Pose>* expanded)
{
  const GoalDistance distance(checker, request.start, request.goal, kFieldSlack, interrupt);
  if (interrupt.cancelled()) return failed(PlanStatus::cancelled);
  if (interrupt.timed_out()) return failed(PlanStatus::timeout);
  if (!distance.reaches_start() || !may_be_reachable(checker, distance, request.start, request.goal, getenv("CS")?atof(getenv("CS")):0.1, interrupt))
    return failed(PlanStatus::goal_unreachable);

  SearchResult found = search(checker, robot, options, request, distance, interrupt, expanded);
  if (found.status == PlanStatus::succeeded && options.terminal_connection)
    found.path = shortened(checker, robot, options, request, std::move(found.path), interrupt);
  return found;
}

}  // namespace fourwis
