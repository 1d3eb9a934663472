#include "fourwis_navigation/planner/back_end.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/optimize/segment_optimizer.h"
#include "fourwis_navigation/optimize/simpson.h"
#include "fourwis_navigation/planner/certificate.h"
#include "fourwis_navigation/planner/stop_and_steer.h"
#include "fourwis_navigation/segment/segment.h"
#include "fourwis_navigation/vehicle/wheels.h"
#include "in_parallel.h"

namespace fourwis
{
namespace
{

/// Accuracy of the rounds before the last, and of the last.
constexpr double kRoughTolerance = 1e-2, kFineTolerance = 1e-6;
/// A region that lets a disc come closer to an obstacle than the first is shrunk so that it keeps the second [m].
constexpr double kLeastClearance = 0.001, kWantedClearance = 0.003;
/// The exact motion from one point may miss the next by this much before the knots are put closer together [m].
constexpr double kMostRolloutMiss = 0.004;
/// A switch is this much longer than the wheels need, for rounding.
constexpr double kSwitchReserve = 1.0 + 1e-6;
/// Points are no closer in time than this [s].
constexpr double kLeastInterval = 1e-3;
/// So often the knots' spacing is halved.
constexpr int kHalvings = 2;

struct RefinedSegment
{
  bool solved = false;
  bool too_coarse = false;  ///< what happens between the knots is the trouble: try again with more of them
  std::string message;
  Trajectory points;
  Corridor corridor;
  int outer_iterations = 0, solver_iterations = 0;
};

class SegmentRefiner
{
public:
  SegmentRefiner(const CollisionChecker& checker, const ObstacleRectangles& obstacles, const Robot& robot,
                 const OptimizeOptions& options, double reference_speed, const Interrupt& interrupt)
    : map_(checker.map()), discs_(disc_cover(robot, options.corridor_discs)), obstacles_(obstacles), robot_(robot),
      options_(options),
      polytopes_{options.corridor_range, PolytopeOptions().max_half_planes}, optimizer_(robot, options, reference_speed), interrupt_(interrupt)
  {
  }

  /// corridor <-> optimisation until the certificate holds.
  RefinedSegment refine(const Segment& reference) const
  {
    RefinedSegment result;
    Segment around = reference;  // what the corridor is built around
    std::vector<double> shrink(reference.intervals(), 0.0);
    std::vector<char> pinned(reference.knots.size(), 0);
    for (int round = 1; round <= options_.outer_iterations + options_.repairs; ++round)
    {
      PolytopeCorridor corridor = polytope_corridor(obstacles_, discs_, polytopes_, around.knots, shrink);
      if (corridor.status != CorridorStatus::succeeded) return give_up(result, corridor.message);
      const bool rough = round < options_.outer_iterations;
      SegmentSolution solution = optimizer_.solve(reference, corridor.regions, round == 1 ? nullptr : &result.points,
                                                  pinned, rough ? kRoughTolerance : kFineTolerance, interrupt_);
      ++result.outer_iterations;
      result.solver_iterations += solution.iterations;
      if (!solution.solved)
      {
        result.too_coarse = !interrupt_.cancelled() && !interrupt_.timed_out();
        return give_up(result, solution.message);
      }
      result.points = std::move(solution.points);
      result.corridor = std::move(corridor.regions);
      const bool certified = is_certified(reference, result, shrink, pinned);
      if (rough)
        for (std::size_t k = 0; k < around.knots.size(); ++k) around.knots[k] = result.points[k].pose();
      else if (certified)
        return result;
    }
    result.too_coarse = true;
    return give_up(result, "the certificate still fails after all repairs");
  }

private:
  RefinedSegment give_up(RefinedSegment& result, const std::string& message) const
  {
    result.solved = false;
    result.message = message;
    return std::move(result);
  }

  /// Sets `solved` when no disc comes too close between the knots. Where one does, shrinks the region, and where the
  /// robot turns back within the interval, out of what the region's chord knows of, makes it stop at the cusp instead.
  bool is_certified(const Segment& reference, RefinedSegment& result, std::vector<double>& shrink,
                    std::vector<char>& pinned) const
  {
    const Certificate certificate = certify(map_, discs_, robot_, result.points);
    result.too_coarse = certificate.worst_rollout > kMostRolloutMiss;
    result.solved = true;
    for (std::size_t k = 0; k < shrink.size(); ++k)
    {
      if (certificate.clearance[k] >= kLeastClearance) continue;
      result.solved = false;
      if (result.points[k].v * result.points[k + 1].v < 0.0)
        for (std::size_t knot = k > 0 ? k : 1; knot <= std::min(k + 1, shrink.size() - 1); ++knot)
          pinned[knot] = std::signbit(reference.length[knot - 1]) != std::signbit(reference.length[knot]);
      else
        shrink[k] += kWantedClearance - certificate.clearance[k];
    }
    return result.solved;
  }

  const ObstacleMap& map_;
  const DiscCover discs_;
  const ObstacleRectangles& obstacles_;
  const Robot& robot_;
  const OptimizeOptions& options_;
  const PolytopeOptions polytopes_;
  const SegmentOptimizer optimizer_;
  const Interrupt& interrupt_;
};

/// The pieces of a path between its switches.
std::vector<Path> parts_between_switches(const Path& path)
{
  std::vector<Path> parts;
  for (const PathPiece& piece : path.pieces)
  {
    if (parts.empty() || parts.back().pieces.back().mode != piece.mode) parts.emplace_back();
    parts.back().pieces.push_back(piece);
  }
  return parts;
}

/// One stretch with the wheels held still: accelerating, cruising and braking on it cannot be improved upon. At full lock
/// there is not even any other motion between its ends.
bool is_one_stretch(const Path& part)
{
  const PathPiece& first = part.pieces.front();
  return std::all_of(part.pieces.begin(), part.pieces.end(), [&](const PathPiece& piece) {
    return piece.phi == first.phi && std::signbit(piece.length) == std::signbit(first.length);
  });
}

/// The same motion with a point of its own wherever the robot turns back between two.
Trajectory split_at_standstill(const Robot& robot, const Trajectory& points)
{
  Trajectory split;
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    split.push_back(points[k]);
    if (k + 1 == points.size() || points[k].v * points[k + 1].v >= 0.0) continue;
    const TrajectoryPoint& p = points[k];
    const double t = -p.v / p.a;
    if (t < kLeastInterval || points[k + 1].t - p.t - t < kLeastInterval) continue;
    SimpsonDynamics::State x;
    x << p.x, p.y, p.theta, p.v, p.phi;
    x = SimpsonDynamics(robot, p.mode).next(x, SimpsonDynamics::Control(p.a, p.omega, t));
    split.push_back({p.t + t, p.mode, x[0], x[1], x[2], 0.0, x[4], p.a, p.omega});
  }
  return split;
}

/// Appends a part that begins at t = 0 after the time the wheels need to turn at rest.
void append(const Robot& robot, const Trajectory& part, Trajectory& whole)
{
  double begin = 0.0;
  if (!whole.empty())
  {
    const TrajectoryPoint &end = whole.back(), &next = part.front();
    begin = end.t + std::max(robot.mode_switch_time,
                             kSwitchReserve * reorientation_time(robot, wheel_angles(robot, end.mode, end.phi),
                                                                 wheel_angles(robot, next.mode, next.phi)));
  }
  for (TrajectoryPoint point : part)
  {
    point.t += begin;
    whole.push_back(point);
  }
}

}  // namespace

Refinement refine(const CollisionChecker& checker, const ObstacleRectangles& obstacles, const Robot& robot,
                  const OptimizeOptions& options, double reference_speed, const Path& path,
                  const Interrupt& interrupt)
{
  const SegmentRefiner refiner(checker, obstacles, robot, options, reference_speed, interrupt);
  const std::vector<Path> parts = parts_between_switches(path);
  std::vector<std::vector<Segment>> segments;  // at the wanted spacing, at half of it, ...
  for (int halving = 0; halving <= kHalvings; ++halving)
    segments.push_back(split_at_switches(path, robot, options.spacing / (1 << halving)));

  std::vector<RefinedSegment> refined(parts.size());
  const bool matches = segments.front().size() == parts.size();
  if (matches)
    in_parallel(parts.size(), [&](std::size_t i) {
      if (is_one_stretch(parts[i])) return;
      for (const std::vector<Segment>& spaced : segments)
      {
        const int rounds = refined[i].outer_iterations, iterations = refined[i].solver_iterations;
        refined[i] = refiner.refine(spaced[i]);
        refined[i].outer_iterations += rounds;
        refined[i].solver_iterations += iterations;
        if (!refined[i].too_coarse) break;
      }
    });

  Refinement result;
  result.segments = static_cast<int>(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const bool usable = refined[i].solved && !refined[i].too_coarse;
    if (!usable && !is_one_stretch(parts[i]))
    {
      ++result.fallbacks;
      result.message = refined[i].solved ? "the exact motion misses the knots" : refined[i].message;
    }
    append(robot,
           usable ? split_at_standstill(robot, refined[i].points) : stop_and_steer(parts[i], robot, reference_speed),
           result.trajectory);
    result.outer_iterations = std::max(result.outer_iterations, refined[i].outer_iterations);
    result.solver_iterations += refined[i].solver_iterations;
    result.corridors.push_back(std::move(refined[i].corridor));
  }
  if (interrupt.cancelled()) result.trajectory.clear();
  return result;
}

}  // namespace fourwis
