#pragma once

#include "fourwis_navigation/map/obstacle_map.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/vehicle/footprint.h"

namespace fourwis
{

/// Is a pose or a motion of the robot free of collisions? Two-disc model, paper eq. (10), on the exact distance.
class CollisionChecker
{
public:
  /// Keeps references: both must outlive the checker.
  CollisionChecker(const ObstacleMap& map, const Robot& robot);

  /// Whether both disc centres are at least r_c away from every obstacle.
  bool is_free(const Pose& pose) const;

  /// How much of a piece can be driven [m], in 0..|length|: along it, checked poses are free and lie so close together
  /// that no disc centre moves more than half of `stride()` between a pose in between and a checked one. With a safety
  /// margin of at least stride()/2 the body itself is then free throughout.
  double free_length(const PathPiece& piece) const;

  bool is_free(const PathPiece& piece) const { return free_length(piece) >= std::abs(piece.length); }

  double stride() const { return stride_; }

  /// What the disc centres keep from every obstacle all along a motion found free [m]: r_c less what they may come closer
  /// between two checks.
  double least_clearance() const { return least_clearance_; }

  const ObstacleMap& map() const { return map_; }
  const TwoDiscs& discs() const { return discs_; }

private:
  bool is_free(double x, double y, double cosine, double sine, double& clearance) const;

  const ObstacleMap& map_;
  const Robot& robot_;
  TwoDiscs discs_;
  double stride_;
  double least_clearance_;
};

}  // namespace fourwis
