#include "grid_frame.h"

#include <cmath>

namespace fourwis
{
namespace
{

void set_pose(TrajectoryPoint& point, const Pose& pose)
{
  point.x = pose.x;
  point.y = pose.y;
  point.theta = pose.theta;
}

}  // namespace

PlanRequest GridFrame::to_grid(PlanRequest request) const
{
  request.start = to_grid(request.start);
  request.goal = to_grid(request.goal);
  return request;
}

Trajectory GridFrame::to_grid(Trajectory trajectory) const
{
  for (TrajectoryPoint& point : trajectory) set_pose(point, to_grid(point.pose()));
  return trajectory;
}

void GridFrame::to_map(Trajectory& trajectory) const
{
  for (TrajectoryPoint& point : trajectory) set_pose(point, to_map(point.pose()));
}

void GridFrame::to_map(PlanResult& result) const
{
  to_map(result.trajectory);
  for (PathPiece& piece : result.path.pieces) piece.start = compose(origin_, piece.start);
  result.path.goal = compose(origin_, result.path.goal);
}

void GridFrame::to_map(PlanTrace& trace) const
{
  for (Pose& pose : trace.expanded) pose = to_map(pose);
  for (std::vector<RefinementRound>& rounds : trace.rounds)
    for (RefinementRound& round : rounds)
    {
      to_map(round.points);
      for (DiscRegions& disc : round.corridor)
        for (Polytope& region : disc.regions)
          for (HalfPlane& plane : region) plane = to_map(plane);
    }
}

HalfPlane GridFrame::to_map(const HalfPlane& plane) const
{
  const double c = std::cos(origin_.theta), s = std::sin(origin_.theta);
  const double a = c * plane.a - s * plane.b, b = s * plane.a + c * plane.b;
  return {a, b, plane.c + a * origin_.x + b * origin_.y};
}

}  // namespace fourwis
