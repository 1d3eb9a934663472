#pragma once

#include <chrono>
#include <optional>
#include <vector>

#include "fourwis_navigation/corridor/obstacle_rectangles.h"
#include "fourwis_navigation/map/obstacle_map.h"
#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/model/interrupt.h"
#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/optimize/optimize_options.h"
#include "fourwis_navigation/planner/refinement_round.h"
#include "fourwis_navigation/referee/referee.h"
#include "fourwis_navigation/search/search_options.h"

namespace fourwis
{

struct PlannerOptions
{
  ObstacleRule obstacles;
  SearchOptions search;
  OptimizeOptions optimize;
  RefereeOptions referee;
  double planner_patience = 5.0;  ///< wall-clock deadline of one plan [s]; then PlanStatus::timeout

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("planner_patience", o.planner_patience, 0.001, 3600.0, "s");
    row.group("", o.obstacles);
    row.group("", o.search);
    row.group("", o.optimize);
    row.group("", o.referee);
  }
};

/// Throws std::invalid_argument, naming key, value and what was expected, where one is out of range, two contradict each
/// other, or one needs Ipopt and has_ipopt() is false.
void check(const PlannerOptions& options);

/// Results of the stages, for pictures and markers. Poses are those of base_link in the map frame. Filled only if asked for.
struct PlanTrace
{
  std::vector<Pose> expanded;                        ///< nodes of the first search in the order of expansion
  std::vector<std::vector<RefinementRound>> rounds;  ///< of each segment of the trajectory, one after the other

  std::vector<Corridor> corridors() const;      ///< of the segments, the last round's
  std::vector<Corridor> all_corridors() const;  ///< those of the rounds before as well
  std::vector<Trajectory> iterations() const;   ///< what came out of the rounds before the last
};

/// A grid and a robot, with everything that is computed from them once. Immutable; share it between plans and threads.
/// Obstacles, rectangles and referee are in the frame of the grid: its origin is taken off.
struct World
{
  World(const OccupancyGrid& grid, const Robot& robot,
        const PlannerOptions& options);  ///< throws as the checks of all three do

  /// Referee::first_violation_from() for a trajectory of base_link in the map frame.
  std::optional<Violation> first_violation_from(double t, const Trajectory& accepted) const;

  Robot robot;
  OccupancyGrid grid;  ///< as it was given
  ObstacleMap obstacles;
  ObstacleRectangles rectangles;
  Referee referee;
  double build_ms;  ///< how long building all this took, wall clock

private:
  World(const OccupancyGrid& grid, const Robot& robot, const PlannerOptions& options,
        std::chrono::steady_clock::time_point begin);
};

/// grid -> search -> paths -> segments -> corridors <-> optimisation -> trajectory -> referee. Deterministic: same input,
/// same output, with any number of threads; only an Interrupt depends on the clock. One planner may be used from
/// several threads.
class Planner
{
public:
  /// Each plan works in as many threads as there are processors. Throws as check() does.
  explicit Planner(const PlannerOptions& options);

  /// Each plan works in at most so many threads, the caller's included. Throws std::invalid_argument also where that is
  /// less than 1.
  Planner(const PlannerOptions& options, int threads);

  /// Plans for the world's robot. Never throws on a request. Request, trajectory and trace are of base_link in the map frame.
  PlanResult plan(const World& world, const PlanRequest& request, const Interrupt& interrupt = {},
                  PlanTrace* trace = nullptr) const;

  /// What plan() says of a goal at which the body overlaps an obstacle or leaves the map, in the time that a look takes;
  /// `succeeded` where it is free. Never throws on a pose.
  PlanResult judge_goal(const World& world, const Pose& goal) const;

  const PlannerOptions& options() const { return options_; }

private:
  PlannerOptions options_;
  int threads_;
};

}  // namespace fourwis
