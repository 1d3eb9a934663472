#pragma once

#include <string>
#include <vector>

#include "certifier.h"
#include "fourwis_navigation/corridor/polytope_corridor.h"
#include "fourwis_navigation/model/segment.h"
#include "fourwis_navigation/optimize/ipopt_segment_optimizer.h"
#include "fourwis_navigation/optimize/segment_optimizer.h"
#include "fourwis_navigation/planner/refinement_round.h"
#include "plan_context.h"

namespace fourwis
{

/// Result for one segment.
struct RefinedSegment
{
  bool solved = false;
  bool too_coarse = false;              ///< the motion between the knots is not valid: more knots may help
  std::string message;                  ///< why it is not solved
  std::vector<RefinementRound> rounds;  ///< the last one's points are the result
  int solver_iterations = 0;

  bool usable() const { return solved && !too_coarse; }
  const Trajectory& points() const { return rounds.back().points; }
};

/// corridor <-> optimisation for one segment after the other, free of collisions as the checker's paths are. May be used
/// from several threads.
class SegmentRefiner
{
public:
  explicit SegmentRefiner(const PlanContext& context);

  /// Rounds of corridor and optimisation until the certificate holds.
  RefinedSegment refine(const Segment& reference) const;

  /// One more round around the last one's result, with twice the knots and more discs. It is added to `rounds` if it is
  /// certified at once and arrives earlier. Whether it is.
  bool polish(std::vector<RefinementRound>& rounds, int& solver_iterations) const;

private:
  struct Attempt;

  PolytopeCorridor corridor(const DiscCover& discs, const std::vector<Pose>& knots,
                            const std::vector<double>& shrink) const;
  SegmentSolution solve(const SegmentTask& task, double tolerance) const;
  bool is_certified(Attempt& attempt, RefinedSegment& result) const;

  const PlanContext context_;
  const OptimizeOptions& options_;
  const DiscCover discs_, fine_discs_;
  const Certifier certifier_, fine_certifier_;
  const SegmentOptimizer structured_;
  const IpoptSegmentOptimizer ipopt_;
};

}  // namespace fourwis
