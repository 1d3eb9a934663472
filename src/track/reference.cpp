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

MotionState state_of(const TrajectoryPoint& point)
{
  return {point.pose(), point.v, point.phi};
}

void shift(TrajectoryPoint& point, const Pose& by, double share)
{
  point.x += share * by.x;
  point.y += share * by.y;
  point.theta += share * by.theta;
}

}  // namespace

Reference::Reference(const Robot& robot, const TrajectoryPoint* first, const TrajectoryPoint* end) : robot_(robot)
{
  assign(first, end);
}

void Reference::assign(const TrajectoryPoint* first, const TrajectoryPoint* end)
{
  points_.assign(first, first + 1);
  for (const TrajectoryPoint* point = first; point + 1 < end; ++point) add_interval(point[0], point[1]);
  const auto [least, greatest] = std::minmax_element(
    first, end, [](const TrajectoryPoint& a, const TrajectoryPoint& b) { return a.phi < b.phi; });
  least_phi_ = least->phi;
  greatest_phi_ = greatest->phi;
}

/// Appends everything after `from`, the last point so far, up to `to`.
void Reference::add_interval(const TrajectoryPoint& from, const TrajectoryPoint& to)
{
  const int parts = std::max(1, static_cast<int>(std::ceil((to.t - from.t) / kSpacing)));
  const double h = (to.t - from.t) / parts;
  const MotionInput input = {(to.v - from.v) / (to.t - from.t), (to.phi - from.phi) / (to.t - from.t)};
  points_.back().a = input.a;
  points_.back().omega = input.omega;
  const std::size_t begin = points_.size();
  MotionState exact = state_of(from);
  for (int i = 1; i <= parts; ++i)
  {
    exact = roll_out(robot_, from.mode, exact, input, h);
    points_.push_back({from.t + i * h, from.mode, exact.pose.x, exact.pose.y, exact.pose.theta, exact.v, exact.phi,
                       input.a, input.omega});
  }
  const Pose miss = {to.x - exact.pose.x, to.y - exact.pose.y, to.theta - exact.pose.theta};
  for (int i = 1; i < parts; ++i) shift(points_[begin + static_cast<std::size_t>(i - 1)], miss, double(i) / parts);
  points_.back() = to;
}

ReferencePoint Reference::at_rest(const TrajectoryPoint& point) const
{
  return {{point.pose(), 0.0, point.phi}, {}};
}

ReferencePoint Reference::at(double t) const
{
  if (!(t > start_time())) return at_rest(points_.front());
  if (t >= end_time()) return at_rest(points_.back());
  const auto next = std::upper_bound(points_.begin(), points_.end(), t,
                                     [](double time, const TrajectoryPoint& point) { return time < point.t; });
  const TrajectoryPoint& point = *std::prev(next);
  const MotionInput input = {point.a, point.omega};
  return {roll_out(robot_, point.mode, state_of(point), input, t - point.t), input};
}

}  // namespace fourwis
