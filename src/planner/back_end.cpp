#include "back_end.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "fourwis_navigation/optimize/simpson.h"
#include "fourwis_navigation/segment/segment.h"
#include "fourwis_navigation/vehicle/wheels.h"
#include "stop_and_steer.h"

namespace fourwis
{

/// A path between two switches.
struct PathPart
{
  Path path;                        ///< its pieces
  std::vector<Segment> references;  ///< with knots at the wanted spacing, at half of it, ...; none: nothing to optimise

  /// The wheels do not turn: accelerating, cruising and braking is optimal on it. At full lock there is no other motion
  /// between its ends.
  bool is_one_stretch() const
  {
    const PathPiece& first = path.pieces.front();
    return std::all_of(path.pieces.begin(), path.pieces.end(), [&](const PathPiece& piece) {
      return piece.phi == first.phi && std::signbit(piece.length) == std::signbit(first.length);
    });
  }
};

namespace
{

/// A switch is this much longer than the wheels need, for rounding.
constexpr double kSwitchReserve = 1.0 + 1e-6;
/// Points are no closer in time than this [s].
constexpr double kLeastInterval = 1e-3;
/// How often the knots' spacing is halved.
constexpr int kHalvings = 2;

/// Pieces in one direction, from standstill to standstill.
std::vector<Path> split_at_cusps(const Path& path)
{
  std::vector<Path> runs;
  for (const PathPiece& piece : path.pieces)
  {
    if (runs.empty() || std::signbit(runs.back().pieces.back().length) != std::signbit(piece.length))
      runs.emplace_back();
    runs.back().pieces.push_back(piece);
  }
  return runs;
}

/// The parts between switches of a path.
std::vector<PathPart> split_path(const Path& path, const Robot& robot, double spacing)
{
  std::vector<PathPart> parts;
  for (const PathPiece& piece : path.pieces)
  {
    if (parts.empty() || parts.back().path.pieces.back().mode != piece.mode) parts.emplace_back();
    parts.back().path.pieces.push_back(piece);
  }
  for (int halving = 0; halving <= kHalvings; ++halving)
  {
    std::vector<Segment> segments = split_at_switches(path, robot, spacing / (1 << halving));
    if (segments.size() != parts.size()) break;
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (!parts[i].is_one_stretch()) parts[i].references.push_back(std::move(segments[i]));
  }
  return parts;
}

/// The same, and the way out of obstacles as a part of its own.
std::vector<PathPart> split(Path path, const Robot& robot, double spacing)
{
  if (!path.begins_with_way_out) return split_path(path, robot, spacing);
  std::vector<PathPart> parts(1);
  parts.front().path.pieces = {path.pieces.front()};
  path.pieces.erase(path.pieces.begin());
  std::vector<PathPart> rest = split_path(path, robot, spacing);
  std::move(rest.begin(), rest.end(), std::back_inserter(parts));
  return parts;
}

/// The same motion, with a further point wherever the robot reverses between two points.
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
    TrajectoryPoint& end = whole.back();
    const TrajectoryPoint& next = part.front();
    const double stand =
        end.mode == next.mode
            ? steering_time(robot, end.mode, end.phi, next.phi)
            : std::max(robot.mode_switch_time,
                       kSwitchReserve * reorientation_time(robot, wheel_angles(robot, end.mode, end.phi),
                                                           wheel_angles(robot, next.mode, next.phi)));
    begin = end.t + stand;
    if (end.mode == next.mode) end.omega = (next.phi - end.phi) / stand;
  }
  for (TrajectoryPoint point : part)
  {
    point.t += begin;
    whole.push_back(point);
  }
}

}  // namespace

BackEnd::BackEnd(const PlanContext& context) : context_(context), refiner_(context) {}

Refinement BackEnd::refine(const Path& path) const
{
  const double spacing = context_.options.optimize.knot_spacing(context_.robot());
  const std::vector<PathPart> parts = split(path, context_.robot(), spacing);
  std::vector<std::vector<RefinedPart>> refined(parts.size());
  context_.threads.for_each(parts.size(), [&](std::size_t i) { refined[i] = refine_in_runs(parts[i], spacing); });
  std::vector<RefinedPart> all;
  for (std::vector<RefinedPart>& runs : refined) std::move(runs.begin(), runs.end(), std::back_inserter(all));
  return assemble(std::move(all));
}

void BackEnd::polish(Refinement& refinement) const
{
  std::vector<RefinedPart> parts = refinement.parts;
  context_.threads.for_each(parts.size(), [&](std::size_t i) { polish(parts[i]); });
  Refinement polished = assemble(std::move(parts));
  // If the wheels end at another angle, they may take longer to turn at the switch.
  const auto later = [](const Trajectory& a, const Trajectory& b) { return !a.empty() && a.back().t > b.back().t; };
  if (!later(polished.trajectory, refinement.trajectory)) refinement = std::move(polished);
}

/// A part as a whole. Where its optimisation fails, one run from cusp to cusp after the other.
std::vector<RefinedPart> BackEnd::refine_in_runs(const PathPart& part, double spacing) const
{
  RefinedPart whole = refine(part);
  const std::vector<Path> runs = split_at_cusps(part.path);
  if (!whole.failed || runs.size() < 2) return {std::move(whole)};
  std::vector<RefinedPart> refined;
  for (const Path& run : runs)
    for (const PathPart& alone : split_path(run, context_.robot(), spacing)) refined.push_back(refine(alone));
  refined.front().solver_iterations += whole.solver_iterations;
  return refined;
}

/// Optimises a part. Where there are too few knots it tries again with more of them.
RefinedPart BackEnd::refine(const PathPart& part) const
{
  RefinedPart result;
  RefinedSegment refined;
  for (const Segment& reference : part.references)
  {
    refined = refiner_.refine(reference);
    result.solver_iterations += refined.solver_iterations;
    std::move(refined.rounds.begin(), refined.rounds.end(), std::back_inserter(result.rounds));
    if (!refined.too_coarse) break;
  }
  result.optimized = refined.usable();
  result.failed = !result.optimized && !part.is_one_stretch();
  if (result.failed) result.message = refined.solved ? "the exact motion misses the knots" : refined.message;
  result.points = result.optimized ? split_at_standstill(context_.robot(), result.rounds.back().points)
                                   : stop_and_steer(part.path, context_.robot());
  return result;
}

void BackEnd::polish(RefinedPart& part) const
{
  if (!part.optimized || !refiner_.polish(part.rounds, part.solver_iterations)) return;
  part.points = split_at_standstill(context_.robot(), part.rounds.back().points);
}

/// Joins the parts and counts over them.
Refinement BackEnd::assemble(std::vector<RefinedPart> parts) const
{
  Refinement whole;
  whole.parts = std::move(parts);
  for (const RefinedPart& part : whole.parts)
  {
    append(context_.robot(), part.points, whole.trajectory);
    whole.outer_iterations = std::max(whole.outer_iterations, static_cast<int>(part.rounds.size()));
    whole.solver_iterations += part.solver_iterations;
    whole.fallbacks += part.failed;
    if (part.failed) whole.message = part.message;
  }
  if (context_.interrupt.cancelled()) whole.trajectory.clear();
  return whole;
}

}  // namespace fourwis
