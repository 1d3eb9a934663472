#include "reference.h"

#include <algorithm>
#include <cmath>

#include "roll_out.h"

namespace fourwis
{
namespace
{

/// Greatest distance of two points in time [s].
constexpr double kSpacing = 0.02;
/// Pieces that are shorter because an interval ends.
constexpr std::size_t kSpare = 16;

MotionState state_of(const TrajectoryPoint& point)
{
  return {point.pose(), point.v, point.phi};
}

Pose drifted(const Pose& pose, const Pose& drift, double time)
{
  return {pose.x + time * drift.x, pose.y + time * drift.y, pose.theta + time * drift.theta};
}

}  // namespace

Reference::Reference(const Robot& robot, const TrajectoryPoint* first, const TrajectoryPoint* end) : robot_(robot)
{
  assign(first, end);
}

void Reference::assign(const TrajectoryPoint* first, const TrajectoryPoint* end)
{
  pieces_.assign(1, {*first, {}});
  for (const TrajectoryPoint* point = first; point + 1 < end; ++point) add_interval(point[0], point[1]);
  const auto [least, greatest] =
      std::minmax_element(first, end, [](const TrajectoryPoint& a, const TrajectoryPoint& b) { return a.phi < b.phi; });
  least_phi_ = least->phi;
  greatest_phi_ = greatest->phi;
}

void Reference::reserve(double duration)
{
  pieces_.reserve(static_cast<std::size_t>(duration / kSpacing) + kSpare);
}

/// Appends everything after `from`, the last point so far, up to `to`.
void Reference::add_interval(const TrajectoryPoint& from, const TrajectoryPoint& to)
{
  const double duration = to.t - from.t;
  const int parts = std::max(1, static_cast<int>(std::ceil(duration / kSpacing)));
  const MotionInput input = {(to.v - from.v) / duration, (to.phi - from.phi) / duration};
  const std::size_t begin = pieces_.size() - 1;
  MotionState exact = state_of(from);
  for (int i = 0; i < parts; ++i)
  {
    const TrajectoryPoint point = {from.t + i * duration / parts,
                                   from.mode,
                                   exact.pose.x,
                                   exact.pose.y,
                                   exact.pose.theta,
                                   exact.v,
                                   exact.phi,
                                   input.a,
                                   input.omega};
    if (i == 0)
      pieces_.back().point = point;
    else
      pieces_.push_back({point, {}});
    exact = roll_out(robot_, from.mode, exact, input, duration / parts);
  }
  const Pose drift = {(to.x - exact.pose.x) / duration, (to.y - exact.pose.y) / duration,
                      (to.theta - exact.pose.theta) / duration};
  for (std::size_t k = begin; k < pieces_.size(); ++k)
  {
    TrajectoryPoint& point = pieces_[k].point;
    const Pose pose = drifted(point.pose(), drift, point.t - from.t);
    point.x = pose.x, point.y = pose.y, point.theta = pose.theta;
    pieces_[k].drift = drift;
  }
  pieces_.push_back({to, {}});
}

ReferencePoint Reference::at_rest(const TrajectoryPoint& point) const
{
  return {{point.pose(), 0.0, point.phi}, {}};
}

ReferencePoint Reference::at(double t) const
{
  if (!(t > start_time())) return at_rest(pieces_.front().point);
  if (t >= end_time()) return at_rest(pieces_.back().point);
  const auto next = std::upper_bound(pieces_.begin(), pieces_.end(), t,
                                     [](double time, const Piece& piece) { return time < piece.point.t; });
  const Piece& piece = *std::prev(next);
  const double time = t - piece.point.t;
  const MotionInput input = {piece.point.a, piece.point.omega};
  ReferencePoint found = {roll_out(robot_, piece.point.mode, state_of(piece.point), input, time), input};
  found.state.pose = drifted(found.state.pose, piece.drift, time);
  return found;
}

}  // namespace fourwis
