#include "segment_refiner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fourwis_navigation/model/option_check.h"
#include "halved_segment.h"

namespace fourwis
{
namespace
{

/// Accuracy of the rounds before the last, and of the last.
constexpr double kRoughTolerance = 1e-2, kFineTolerance = 1e-6;
/// A region that lets a disc come closer to an obstacle than the first is shrunk so that it keeps the second [m].
constexpr double kLeastClearance = 0.0006, kWantedClearance = 0.003;
/// The exact motion from one point may miss the next by this much before the knots are put closer together [m].
constexpr double kMostRolloutMiss = 0.004;

/// In a polished motion no disc is expected to be farther than this from where it was before [m].
constexpr double kPolishReach = 0.5;

RefinedSegment give_up(RefinedSegment&& result, const std::string& message)
{
  result.solved = false;
  result.message = message;
  return std::move(result);
}

bool turns_back(const Segment& segment, std::size_t knot)
{
  return std::signbit(segment.length[knot - 1]) != std::signbit(segment.length[knot]);
}

/// Whether a disc that moves from one pose to the other comes nearer to the half plane's edge than `reach`.
bool comes_near(const HalfPlane& plane, const Point2& centre, const TrajectoryPoint& from, const TrajectoryPoint& to,
                double reach)
{
  const auto gap = [&](const TrajectoryPoint& p) {
    const Pose place = compose(p.pose(), {centre.x, centre.y, 0.0});
    return plane.c - plane.a * place.x - plane.b * place.y;
  };
  return std::min(gap(from), gap(to)) < reach;
}

/// The regions without the edges that are farther than `reach` from the points, which cost time and bind nothing. A disc
/// that goes farther than that may leave them, which the certificate tells.
Corridor near_edges(const Corridor& corridor, const Trajectory& points, double reach)
{
  Corridor near = corridor;
  for (DiscRegions& disc : near)
    for (std::size_t k = 0; k < disc.regions.size(); ++k)
    {
      Polytope& region = disc.regions[k];
      const auto is_far = [&](const HalfPlane& plane) {
        return !comes_near(plane, disc.centre, points[k], points[k + 1], reach);
      };
      region.erase(std::remove_if(region.begin(), region.end(), is_far), region.end());
    }
  return near;
}

Certifier certifier(const CollisionChecker& checker, const DiscCover& discs)
{
  return Certifier(checker.map(), checker.robot(), without_margin(discs, checker.robot()));
}

}  // namespace

/// Input of a round.
struct SegmentRefiner::Attempt
{
  explicit Attempt(const Segment& segment)
    : reference(segment),
      around(segment.knots),
      shrink(segment.intervals(), 0.0),
      pinned(segment.knots.size(), 0)
  {}

  /// Makes the robot stop where it reverses at the ends of interval k. False if there is no such place left.
  bool pin_cusps_of(std::size_t k)
  {
    bool found = false;
    for (std::size_t knot = std::max<std::size_t>(k, 1); knot <= std::min(k + 1, shrink.size() - 1); ++knot)
    {
      if (pinned[knot] || !turns_back(reference, knot)) continue;
      found = true;
      pinned[knot] = true;
    }
    return found;
  }

  const Segment& reference;
  std::vector<Pose> around;    ///< the corridor is built around these knots
  std::vector<double> shrink;  ///< how much smaller than possible the regions of each interval are [m]
  std::vector<char> pinned;    ///< where the robot is to stop
};

SegmentRefiner::SegmentRefiner(const PlanContext& context)
  : context_(context),
    options_(checked(context.options.optimize)),
    discs_(disc_cover(context.robot(), options_.corridor_discs)),
    fine_discs_(disc_cover(context.robot(), options_.polish_discs)),
    certifier_(certifier(context.checker, discs_)),
    fine_certifier_(certifier(context.checker, fine_discs_)),
    structured_(context.robot(), options_, context.reference_speed()),
    ipopt_(context.robot(), options_, context.reference_speed())
{}

RefinedSegment SegmentRefiner::refine(const Segment& reference) const
{
  RefinedSegment result;
  Attempt attempt(reference);
  for (int round = 1; round <= options_.outer_iterations + options_.repairs; ++round)
  {
    PolytopeCorridor regions = corridor(discs_, attempt.around, attempt.shrink);
    if (regions.status != CorridorStatus::succeeded) return give_up(std::move(result), regions.message);
    const bool rough = round < options_.outer_iterations;
    const Trajectory* previous = round == 1 ? nullptr : &result.points();
    SegmentSolution solution =
        solve({reference, regions.regions, previous, attempt.pinned}, rough ? kRoughTolerance : kFineTolerance);
    result.solver_iterations += solution.iterations;
    result.rounds.push_back({std::move(regions.regions), std::move(solution.points)});
    if (!solution.solved)
    {
      result.too_coarse = !context_.interrupt.cancelled() && !context_.interrupt.timed_out();
      return give_up(std::move(result), solution.message);
    }
    const bool certified = is_certified(attempt, result);
    if (rough)
      std::transform(result.points().begin(), result.points().end(), attempt.around.begin(),
                     [](const TrajectoryPoint& point) { return point.pose(); });
    else if (certified)
      return result;
  }
  result.too_coarse = true;
  return give_up(std::move(result), "the certificate still fails after all repairs");
}

bool SegmentRefiner::polish(std::vector<RefinementRound>& rounds, int& solver_iterations) const
{
  const HalvedSegment halved(context_.robot(), rounds.back().points);
  PolytopeCorridor regions = corridor(fine_discs_, halved.reference.knots, {});
  if (regions.status != CorridorStatus::succeeded) return false;
  const Corridor near = near_edges(regions.regions, halved.points, kPolishReach);
  SegmentSolution solution = solve({halved.reference, near, &halved.points}, kFineTolerance);
  solver_iterations += solution.iterations;
  if (!solution.solved || solution.points.back().t >= rounds.back().points.back().t) return false;
  const Certificate certificate = fine_certifier_.certify(solution.points);
  if (certificate.worst_rollout > kMostRolloutMiss || certificate.least_clearance() < kLeastClearance) return false;
  rounds.push_back({std::move(regions.regions), std::move(solution.points)});
  return true;
}

PolytopeCorridor SegmentRefiner::corridor(const DiscCover& discs, const std::vector<Pose>& knots,
                                          const std::vector<double>& shrink) const
{
  PolytopeOptions options;
  options.range = options_.range(context_.robot());
  return polytope_corridor(context_.world.rectangles, discs, options, knots, shrink);
}

SegmentSolution SegmentRefiner::solve(const SegmentTask& task, double tolerance) const
{
  if (options_.solver == NlpSolver::ipopt) return ipopt_.solve(task, tolerance, context_.interrupt);
  return structured_.solve(task, tolerance, context_.interrupt);
}

/// Sets `solved` if no disc comes too close between the knots. If one does, the robot is made to stop at a cusp beside
/// the interval, because it may pass the cusp far away from the region's chord. If it stops there already, the region
/// is shrunk.
bool SegmentRefiner::is_certified(Attempt& attempt, RefinedSegment& result) const
{
  const Trajectory& points = result.points();
  const Certificate certificate = certifier_.certify(points);
  result.too_coarse = certificate.worst_rollout > kMostRolloutMiss;
  result.solved = true;
  for (std::size_t k = 0; k < attempt.shrink.size(); ++k)
  {
    if (certificate.clearance[k] >= kLeastClearance) continue;
    result.solved = false;
    if (!attempt.pin_cusps_of(k)) attempt.shrink[k] += kWantedClearance - certificate.clearance[k];
  }
  return result.solved;
}

}  // namespace fourwis
