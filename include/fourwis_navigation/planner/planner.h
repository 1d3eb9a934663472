#pragma once

#include <chrono>
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
};

/// Throws std::invalid_argument, with a sentence, where options contradict each other.
void check(const PlannerOptions& options);

/// What the stages leave behind for somebody who wants to look at them; filled only when asked for.
struct PlanTrace
{
  std::vector<Pose> expanded;                        ///< nodes of the first search in the order of expansion
  std::vector<std::vector<RefinementRound>> rounds;  ///< of each segment of the trajectory, one after the other

  std::vector<Corridor> corridors() const;      ///< of the segments, the last round's
  std::vector<Corridor> all_corridors() const;  ///< those of the rounds before as well
  std::vector<Trajectory> iterations() const;   ///< what came out of the rounds before the last
};

/// A grid and a robot with everything that can be computed from them once. Immutable; share it between plans and threads.
struct World
{
  World(const OccupancyGrid& grid, const Robot& robot,
        const PlannerOptions& options);  ///< throws std::invalid_argument

  Robot robot;
  OccupancyGrid grid;
  ObstacleMap obstacles;
  ObstacleRectangles rectangles;
  Referee referee;
  double build_ms;  ///< how long building all this took, wall clock

private:
  World(const OccupancyGrid& grid, const Robot& robot, const PlannerOptions& options,
        std::chrono::steady_clock::time_point begin);
};

/// grid -> search -> paths -> segments -> corridors <-> optimisation -> trajectory -> referee. Deterministic: same input, same output; only an Interrupt depends on
/// the clock. One planner may be used from several threads.
class Planner
{
public:
  Planner(const Robot& robot, const PlannerOptions& options);  ///< throws as check() does

  /// Never throws on a request, whatever is in it.
  PlanResult plan(const World& world, const PlanRequest& request, const Interrupt& interrupt = {},
                  PlanTrace* trace = nullptr) const;

  const Robot& robot() const { return robot_; }
  const PlannerOptions& options() const { return options_; }

private:
  Robot robot_;
  PlannerOptions options_;
};

}  // namespace fourwis
