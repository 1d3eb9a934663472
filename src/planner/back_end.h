#pragma once

#include <string>
#include <vector>

#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/planner/refinement_round.h"
#include "plan_context.h"
#include "segment_refiner.h"

namespace fourwis
{

/// Result of the back end for a path between two switches.
struct RefinedPart
{
  bool optimized = false;               ///< if not, stop_and_steer drives it
  bool failed = false;                  ///< the optimisation failed or there was nothing to optimise
  std::string message;                  ///< why it failed
  Trajectory points;                    ///< from t = 0
  std::vector<RefinementRound> rounds;  ///< all of them, those that failed included
  int solver_iterations = 0;
};

/// Result of the back end for a path.
struct Refinement
{
  Trajectory trajectory;  ///< of the whole path; empty when cancelled
  std::vector<RefinedPart> parts;
  int fallbacks = 0;          ///< segments that are driven by stop_and_steer because their optimisation failed
  int outer_iterations = 0;   ///< rounds of corridor and optimisation, most of all segments
  int solver_iterations = 0;  ///< sum over segments and rounds
  std::string message;        ///< why a segment fell back, if one did
};

struct PathPart;

/// The paper's section III-B with the regions and the solver described in doc/deviations.md, for any paths of one plan.
/// Deterministic with any number of threads; may be used from several at once.
class BackEnd
{
public:
  explicit BackEnd(const PlanContext& context);

  /// Splits the path at its switches, optimises each part and joins them with stationary switches.
  Refinement refine(const Path& path) const;

  /// One more round for each optimised segment around its result, with twice the knots and with discs that extend less
  /// beyond the body. So the robot can steer faster and cut corners closer. A segment stays as it is if the new one is
  /// not certified at once or arrives later. The whole trajectory stays as it is if the new one arrives later.
  void polish(Refinement& refinement) const;

private:
  std::vector<RefinedPart> refine_in_runs(const PathPart& part, double spacing) const;
  RefinedPart refine(const PathPart& part) const;
  void polish(RefinedPart& part) const;
  Refinement assemble(std::vector<RefinedPart> parts) const;

  const PlanContext context_;
  const SegmentRefiner refiner_;
};

}  // namespace fourwis
