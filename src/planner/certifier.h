#pragma once

#include <algorithm>
#include <vector>

#include "fourwis_navigation/map/obstacle_map.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/optimize/simpson.h"
#include "fourwis_navigation/vehicle/body.h"
#include "fourwis_navigation/vehicle/footprint.h"

namespace fourwis
{

/// What was found between the knots of an optimised segment, for each interval.
struct Certificate
{
  std::vector<double> clearance;  ///< least distance of the discs to obstacles [m]; negative in collision. Distances
                                  ///< beyond some centimetres are not looked at closely
  double worst_rollout = 0.0;     ///< greatest miss of the next point by the exact motion [m]

  double least_clearance() const
  {
    return clearance.empty() ? 0.0 : *std::min_element(clearance.begin(), clearance.end());
  }
};

/// Checks poses of the motion between the points of one mode. They are so close together that between two of them no
/// disc centre comes nearer to an obstacle by more than half a millimetre.
class Certifier
{
public:
  /// Keeps references to map and robot. The discs (without safety margin) or the body itself may show a pose to be clear.
  Certifier(const ObstacleMap& map, const Robot& robot, const DiscCover& discs);

  Certificate certify(const Trajectory& points) const;

private:
  /// The body with a margin that tells clearances apart.
  struct GrownBody
  {
    double margin;
    ConvexPolygon outline;
  };

  double least_clearance(const SimpsonDynamics& dynamics, const TrajectoryPoint& from, const TrajectoryPoint& to) const;
  double greatest_speed_of_body(const TrajectoryPoint& from, const TrajectoryPoint& to) const;
  double clearance_at(const SimpsonDynamics::State& x) const;

  const ObstacleMap& map_;
  const Robot& robot_;
  const DiscCover discs_;
  std::vector<GrownBody> bodies_;  ///< from the largest to the smallest
  double reach_;                   ///< of the farthest point that is checked from C [m]
};

}  // namespace fourwis
