#pragma once

#include <cmath>
#include <vector>

#include "fourwis_navigation/map/obstacle_map.h"
#include "fourwis_navigation/model/path.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/vehicle/body.h"
#include "fourwis_navigation/vehicle/footprint.h"

namespace fourwis
{

/// Is a pose or a motion of the robot free of collisions? Two-disc model, paper eq. (10), on the exact distance; for places
/// where two discs do not fit, the body itself.
class CollisionChecker
{
public:
  /// Keeps references: both must outlive the checker. Throws as check(robot) does.
  CollisionChecker(const ObstacleMap& map, const Robot& robot);

  /// The same, but free is as well where the body keeps the safety margin on each side or, near a pose in `tight`, as much of
  /// it as it has there. The body must be clear at these poses.
  CollisionChecker(const ObstacleMap& map, const Robot& robot, const std::vector<Pose>& tight);

  /// Whether both disc centres are at least r_c away from every obstacle, or the body is clear.
  bool is_free(const Pose& pose) const;

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

  /// Whether the body itself may show a pose to be free.
  bool goes_by_body() const { return goes_by_body_; }

  /// A place around which the body keeps less than the safety margin.
  struct TightSpot
  {
    double x, y;
    double margin;              ///< it keeps there [m]
    ConvexPolygon with_margin;  ///< the body, grown by that

    bool is_near(double px, double py) const { return std::hypot(px - x, py - y) < kRadius; }
    static constexpr double kRadius = 1.0;  ///< [m]
  };
  const std::vector<TightSpot>& tight_spots() const { return tight_; }

  /// The body with the margin that it keeps where no tight spot is near.
  const ConvexPolygon& body_with_margin() const { return with_margin_; }

private:
  /// The body with its margin, grown.
  struct LargerBody
  {
    double by;  ///< [m]
    ConvexPolygon outline;
  };

  double room(double x, double y, double cosine, double sine, std::size_t& step) const;
  const ConvexPolygon& with_margin_at(double x, double y) const;
  bool is_free(double x, double y, double cosine, double sine, double& clearance) const;
  bool are_clear(const TwoDiscs& discs, double x, double y, double cosine, double sine, double& clearance) const;

  const ObstacleMap& map_;
  const Robot& robot_;
  TwoDiscs discs_, needed_;
  bool goes_by_body_ = false;
  ConvexPolygon with_margin_;
  std::vector<LargerBody> larger_;
  std::vector<TightSpot> tight_;
  double stride_;
  double reach_;  ///< of the disc centre farthest from C, the centre of the wheels [m]
  double least_clearance_;
};

}  // namespace fourwis
