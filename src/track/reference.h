#pragma once

#include <vector>

#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"
#include "motion_state.h"

namespace fourwis
{

/// Where the robot should be at some time, and the input that keeps it there.
struct ReferencePoint
{
  MotionState state;
  MotionInput input;
};

/// One stretch of a trajectory: neighbouring points of one mode. Between the points v and phi are linear and the pose
/// is rolled out. The roll-out may miss the next point by up to 5 mm (doc/design.md, "The meaning of a trajectory").
/// This error is spread over the interval, so that the reference has no jumps. Before its beginning and after its end
/// the reference is at rest.
class Reference
{
public:
  /// The points from `first` up to `end`: at least one, of one mode, times increasing.
  Reference(const Robot& robot, const TrajectoryPoint* first, const TrajectoryPoint* end);

  /// Another stretch instead. Allocates only where it is longer than any before.
  void assign(const TrajectoryPoint* first, const TrajectoryPoint* end);

  /// Room for a stretch of that duration [s].
  void reserve(double duration);

  Mode mode() const { return pieces_.front().point.mode; }
  double start_time() const { return pieces_.front().point.t; }
  double end_time() const { return pieces_.back().point.t; }
  Pose start_pose() const { return pieces_.front().point.pose(); }
  Pose end_pose() const { return pieces_.back().point.pose(); }

  /// At time t of the trajectory. Time logarithmic in the number of points.
  ReferencePoint at(double t) const;

  double start_phi() const { return pieces_.front().point.phi; }
  double least_phi() const { return least_phi_; }
  double greatest_phi() const { return greatest_phi_; }

private:
  /// A point, and the drift with which the roll-out from it meets the next one. The two are so close together that the
  /// roll-out is practically exact.
  struct Piece
  {
    TrajectoryPoint point;
    Pose drift;  ///< [m/s], [rad/s]
  };

  void add_interval(const TrajectoryPoint& from, const TrajectoryPoint& to);
  ReferencePoint at_rest(const TrajectoryPoint& point) const;

  Robot robot_;
  std::vector<Piece> pieces_;
  double least_phi_, greatest_phi_;
};

}  // namespace fourwis
