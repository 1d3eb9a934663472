#pragma once

#include <string>
#include <vector>

#include "fourwis_navigation/corridor/polytope_corridor.h"
#include "fourwis_navigation/map/collision.h"
#include "fourwis_navigation/model/interrupt.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/optimize/optimize_options.h"
#include "fourwis_navigation/planner/refinement_round.h"

namespace fourwis
{

/// What the back end made of a path between two switches.
struct RefinedPart
{
  bool optimized = false;               ///< otherwise stop_and_steer drives it
  std::string message;                  ///< why it is not optimised, unless there is nothing to optimise
  Trajectory points;                    ///< from t = 0
  std::vector<RefinementRound> rounds;  ///< all of them, those that failed included
  int solver_iterations = 0;
};

/// What the back end made of a path.
struct Refinement
{
  Trajectory trajectory;  ///< of the whole path; empty when cancelled
  std::vector<RefinedPart> parts;
  int fallbacks = 0;          ///< segments that are driven by stop_and_steer because their optimisation failed
  int outer_iterations = 0;   ///< rounds of corridor and optimisation, most of all segments
  int solver_iterations = 0;  ///< sum over segments and rounds
  std::string message;        ///< why a segment fell back, if one did
};

/// The paper's section III-B with the regions and the solver described in doc/deviations.md: the path is split at its
/// switches, each segment goes through corridor <-> optimisation, on threads of their own, and the parts are joined with
/// stationary switches. Deterministic with any number of threads.
Refinement refine(const CollisionChecker& checker, const ObstacleRectangles& obstacles, const Robot& robot,
                  const OptimizeOptions& options, double reference_speed, const Path& path, const Interrupt& interrupt);

/// One more round for each optimised segment around its result, with twice the knots and discs that stick out less, so
/// that the robot can steer faster and cut corners closer. Segments for which that is not certified at once, or arrives
/// later, stay as they are, and so does all if it does.
void polish(const CollisionChecker& checker, const ObstacleRectangles& obstacles, const Robot& robot,
            const OptimizeOptions& options, double reference_speed, const Interrupt& interrupt, Refinement& refinement);

}  // namespace fourwis
