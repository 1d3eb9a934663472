#pragma once

#include <optional>
#include <vector>

#include "fourwis_navigation/map/obstacle_map.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/vehicle/footprint.h"

namespace fourwis
{

/// Is a pose or a motion of the robot free of collisions? Two-disc model, paper eq. (10), on the exact distance; for places
/// where two discs do not fit, many small ones in their place.
class CollisionChecker
{
public:
  /// Keeps references: both must outlive the checker. Throws as check(robot) does.
  CollisionChecker(const ObstacleMap& map, const Robot& robot);

  /// The same, but free is as well where the snug cover keeps the safety margin or, within a metre of a pose in `tight`, as
  /// much of it as it has there.
  CollisionChecker(const ObstacleMap& map, const Robot& robot, const std::vector<Pose>& tight);

  /// Whether both disc centres are at least r_c away from every obstacle, or the snug cover is clear.
  bool is_free(const Pose& pose) const;

  /// By how much the discs are farther from obstacles than they have to be [m]; negative at a pose that is not free.
  double clearance(const Pose& pose) const;

  /// How much of a piece can be driven [m], in 0..|length|: along it, checked poses are free and lie so close together
  /// that no disc centre moves more than half of `stride()` between a pose in between and a checked one. With a safety
  /// margin of at least stride()/2 the body itself is then free throughout.
  double free_length(const PathPiece& piece) const;

  bool is_free(const PathPiece& piece) const { return free_length(piece) >= std::abs(piece.length); }

  double stride() const { return stride_; }

  /// What the centres of discs() keep from every obstacle all along a motion found free [m]: their radius less what they
  /// may come closer between two checks.
  double least_clearance() const { return least_clearance_; }

  const ObstacleMap& map() const { return map_; }
  const Robot& robot() const { return robot_; }

  /// Two discs whose centres keep `radius` at every pose found free.
  const TwoDiscs& discs() const { return needed_; }

  /// The small discs, without margin; none for a checker that goes by two discs alone.
  const std::optional<DiscCover>& snug() const { return snug_; }

private:
  /// A place where the snug cover comes closer to obstacles than the safety margin.
  struct TightSpot
  {
    double x, y;
    double margin;  ///< it keeps there [m]
  };

  double margin_at(double x, double y) const;
  bool is_free(double x, double y, double cosine, double sine, double& clearance) const;
  bool are_clear(const TwoDiscs& discs, double x, double y, double cosine, double sine, double& clearance) const;
  bool is_snug_free(double x, double y, double cosine, double sine, double& clearance) const;

  const ObstacleMap& map_;
  const Robot& robot_;
  TwoDiscs discs_, needed_;
  std::optional<DiscCover> snug_;
  std::vector<Point2> rim_;  ///< centres of those discs of the snug cover that the inscribed two do not contain
  std::vector<TightSpot> tight_;
  double stride_;
  double reach_;  ///< of the disc centre farthest from C, the centre of the wheels [m]
  double least_clearance_;
};

/// Least distance of the discs to obstacles at a pose [m]; negative in collision.
double clearance(const ObstacleMap& map, const DiscCover& discs, const Pose& pose);

}  // namespace fourwis
