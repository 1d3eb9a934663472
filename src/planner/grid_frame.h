#pragma once

#include "fourwis_navigation/model/plan.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/planner/planner.h"
#include "fourwis_navigation/vehicle/base_link.h"

namespace fourwis
{

/// Plans are made in the frame of the grid and of C, the centre of the wheels, so that they depend neither on where the grid lies
/// in the map frame nor on where base_link is. Users' poses are those of base_link in the map frame. An origin of zero and a
/// base_link at C change no bit.
class GridFrame
{
public:
  /// Of a grid whose corner is at `origin` in the map frame.
  GridFrame(const Pose& origin, const Robot& robot) : origin_(origin), base_link_(robot) {}

  Pose to_grid(const Pose& pose) const { return relative_to(origin_, base_link_.to_centre(pose)); }
  PlanRequest to_grid(PlanRequest request) const;
  Trajectory to_grid(Trajectory trajectory) const;

  Pose to_map(const Pose& pose) const { return base_link_.from_centre(compose(origin_, pose)); }
  void to_map(Trajectory& trajectory) const;
  void to_map(PlanResult& result) const;  ///< its path stays one of C
  void to_map(PlanTrace& trace) const;

private:
  HalfPlane to_map(const HalfPlane& plane) const;

  const Pose origin_;
  const BaseLink base_link_;
};

}  // namespace fourwis
