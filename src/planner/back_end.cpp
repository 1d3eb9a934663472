#include "back_end.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "fourwis_navigation/optimize/simpson.h"
#include "fourwis_navigation/segment/segment.h"
#include "fourwis_navigation/vehicle/wheels.h"
#include "in_parallel.h"
#include "segment_refiner.h"
#include "stop_and_steer.h"

namespace fourwis
{
namespace
{

/// A switch is this much longer than the wheels need, for rounding.
constexpr double kSwitchReserve = 1.0 + 1e-6;
/// Points are no closer in time than this [s].
constexpr double kLeastInterval = 1e-3;
/// So often the knots' spacing is halved.
constexpr int kHalvings = 2;

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

/// Optimises the i-th segment, at smaller and smaller spacing where that is the trouble.
void refine_part(const SegmentRefiner& refiner, const Robot& robot, const std::vector<std::vector<Segment>>& segments,
                 std::size_t i, RefinedPart& part)
{
  RefinedSegment refined;
  for (const std::vector<Segment>& spaced : segments)
  {
    refined = refiner.refine(spaced[i]);
    part.solver_iterations += refined.solver_iterations;
    std::move(refined.rounds.begin(), refined.rounds.end(), std::back_inserter(part.rounds));
    if (!refined.too_coarse) break;
  }
  part.optimized = refined.usable();
  part.message = refined.solved ? "the exact motion misses the knots" : refined.message;
  if (part.optimized) part.points = split_at_standstill(robot, part.rounds.back().points);
}

/// What is said of the parts together.
void finish(const Robot& robot, const Interrupt& interrupt, Refinement& refinement)
{
  refinement.trajectory.clear();
  refinement.outer_iterations = refinement.solver_iterations = 0;
  for (const RefinedPart& part : refinement.parts)
  {
    append(robot, part.points, refinement.trajectory);
    refinement.outer_iterations = std::max(refinement.outer_iterations, static_cast<int>(part.rounds.size()));
    refinement.solver_iterations += part.solver_iterations;
  }
  if (interrupt.cancelled()) refinement.trajectory.clear();
}

}  // namespace

Refinement refine(const CollisionChecker& checker, const ObstacleRectangles& obstacles, const Robot& robot,
                  const OptimizeOptions& options, double reference_speed, const Path& path, const Interrupt& interrupt)
{
  const SegmentRefiner refiner(checker, obstacles, robot, options, reference_speed, interrupt);
  const std::vector<Path> paths = parts_between_switches(path);
  std::vector<std::vector<Segment>> segments;  // at the wanted spacing, at half of it, ...
  for (int halving = 0; halving <= kHalvings; ++halving)
    segments.push_back(split_at_switches(path, robot, options.spacing / (1 << halving)));

  Refinement result;
  result.parts.resize(paths.size());
  in_parallel(paths.size(), [&](std::size_t i) {
    if (segments.front().size() == paths.size() && !is_one_stretch(paths[i]))
      refine_part(refiner, robot, segments, i, result.parts[i]);
    if (!result.parts[i].optimized) result.parts[i].points = stop_and_steer(paths[i], robot, reference_speed);
  });
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    if (result.parts[i].optimized || is_one_stretch(paths[i])) continue;
    ++result.fallbacks;
    result.message = result.parts[i].message;
  }
  finish(robot, interrupt, result);
  return result;
}

void polish(const CollisionChecker& checker, const ObstacleRectangles& obstacles, const Robot& robot,
            const OptimizeOptions& options, double reference_speed, const Interrupt& interrupt, Refinement& refinement)
{
  const SegmentRefiner refiner(checker, obstacles, robot, options, reference_speed, interrupt);
  Refinement before = refinement;
  in_parallel(refinement.parts.size(), [&](std::size_t i) {
    RefinedPart& part = refinement.parts[i];
    if (!part.optimized || !refiner.polish(part.rounds, part.solver_iterations)) return;
    part.points = split_at_standstill(robot, part.rounds.back().points);
  });
  finish(robot, interrupt, refinement);
  // Wheels that end elsewhere may take longer to turn at the switch.
  const auto later = [](const Trajectory& a, const Trajectory& b) { return !a.empty() && a.back().t > b.back().t; };
  if (later(refinement.trajectory, before.trajectory)) refinement = std::move(before);
}

}  // namespace fourwis
