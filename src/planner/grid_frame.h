#pragma once

#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/planner/planner.h"

namespace fourwis
{

/// Plans are made in the frame of the grid, so that they do not depend on where the grid lies in the map frame. An origin of
/// zero changes no bit.
class GridFrame
{
public:
  /// Of a grid whose corner is at `origin` in the map frame.
  explicit GridFrame(const Pose& origin) : origin_(origin) {}

  Pose to_grid(const Pose& pose) const { return relative_to(origin_, pose); }
  PlanRequest to_grid(PlanRequest request) const;
  Trajectory to_grid(Trajectory trajectory) const;

  Pose to_map(const Pose& pose) const { return compose(origin_, pose); }
  void to_map(Trajectory& trajectory) const;
  void to_map(PlanResult& result) const;
  void to_map(PlanTrace& trace) const;

private:
  HalfPlane to_map(const HalfPlane& plane) const;

  const Pose origin_;
};

}  // namespace fourwis
