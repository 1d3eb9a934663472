#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fourwis_navigation/model/occupancy_grid.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/trajectory.h"

namespace fourwis
{

namespace referee
{
class ObstacleCells;
}

/// What the referee insists on: doc/design.md, "The meaning of a trajectory".
struct RefereeOptions
{
  double collision_step = 0.01;      ///< greatest motion of any body point between two collision checks [m]
  double rollout_position = 0.005;   ///< rolling out from one point must meet the next within this [m]
  double rollout_angle = 0.01;       ///< and this [rad]
  double endpoint_position = 0.001;  ///< start and goal are met within this [m]
  double endpoint_angle = 0.001;     ///< and this [rad]
  double start_tolerance = 0.03;     ///< greatest depth by which the body may overlap obstacles at the start [m]
  double limit_tolerance = 1e-6;     ///< relative excess of a limit that still counts as rounding

  /// The table of the options; see model/option_check.h. The fixed rows are part of the meaning of a trajectory, so
  /// they are not parameters.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("collision_step", o.collision_step, 0.0005, 0.01, "m");
    row("start_tolerance", o.start_tolerance, 0.0, 0.5, "m");
    row.fixed("rollout_position", o.rollout_position, 0.0, 1.0, "m");
    row.fixed("rollout_angle", o.rollout_angle, 0.0, 1.0, "rad");
    row.fixed("endpoint_position", o.endpoint_position, 0.0, 1.0, "m");
    row.fixed("endpoint_angle", o.endpoint_angle, 0.0, 1.0, "rad");
    row.fixed("limit_tolerance", o.limit_tolerance, 0.0, 1.0);
  }
};

/// Throws std::invalid_argument naming key, value and range.
void check(const RefereeOptions& options);

/// One broken rule.
struct Violation
{
  int point = 0;     ///< index of the trajectory point at or after which it happens
  double t = 0.0;    ///< when [s]
  std::string what;  ///< quantity, value, limit: a sentence
};

struct Verdict
{
  std::vector<Violation> violations;  ///< empty: accepted. At most five of a kind, in the order of the points
  /// Least distance of the body to an obstacle cell or the border of the grid [m]; 0 when touching or overlapping.
  /// Exact at the poses looked at, which are so close that it is at most 1/8 or half a collision_step too large. 0 when
  /// the points were no trajectory at all, and then so are the numbers below.
  double min_clearance = 0.0;
  double max_rollout_position = 0.0;     ///< worst miss of a rolled-out step [m]
  double max_rollout_angle = 0.0;        ///< likewise [rad]
  double terminal_position_error = 0.0;  ///< TPE [m]
  double terminal_yaw_error = 0.0;       ///< TYE [rad]

  bool accepted() const { return violations.empty(); }
};

/// Judges trajectories on one grid. It shares no code with what it judges: own kinematics, own integration, own
/// collision check of the exact body against the grid's cells. Safe to use from several threads at once.
///
/// A trajectory is accepted when
///  1. it has a point, starts at t = 0, its times increase, its numbers are finite, its modes are planned ones;
///  2. it starts at rest at the start pose and ends at rest at the goal pose. Start equal to goal: one point will do;
///  3. between neighbours of one mode, v and phi taken as linear in time, the re-integrated kinematics meet the next
///     point (theta is not wrapped), and `a` and `omega` say the same as the differences, to 1e-3 of the limits;
///  4. speed, acceleration, steering angle (in parallel mode: within the wheels' travel) and steering rate keep their
///     limits;
///  5. between neighbours of different modes the pose stays (1e-6 m, 1e-6 rad), v = 0 (1e-6 m/s), and the time suffices
///     for t_switch and for each wheel to turn from its old to its new angle;
///  6. each wheel keeps its rate and speed, and within each stretch without rest some branch (angle + k pi) of its
///     angle stays within its travel. At rest a wheel may turn the shorter way, modulo pi, that its travel allows;
///  7. the interior of the body, a convex polygon, meets no obstacle cell and does not leave the grid. Touching is allowed,
///     and an overlap of 1e-9 m still counts as touching. Where the body overlaps at the start by no more than
///     start_tolerance, it may go on as long as it never gets deeper, until it is free. The depth is by how much each side of
///     the body has to be moved inward for that;
///  8. it is not longer than anything sensible (20 km).
class Referee
{
public:
  /// Throws std::invalid_argument naming field, value and what was expected when grid, robot or options are unusable.
  /// Time linear in the number of cells; the grid is not kept. `frame` is where the frame of grid and trajectories lies in
  /// the one that sentences tell poses in. Poses are those of C, the centre of the wheels, in sentences those of base_link.
  Referee(const OccupancyGrid& grid, const ObstacleRule& rule, const Robot& robot, const RefereeOptions& options = {},
          const Pose& frame = {});

  /// Never throws on a bad trajectory. NaN, no points at all or times that run backward are violations.
  Verdict judge(const Pose& start, const Pose& goal, const Trajectory& trajectory) const;

  /// The first rule about the motion (3. and 7.) that is broken at time t [s] or later, for a trajectory that was accepted
  /// on another grid: where the body would meet what has been added since. No overlap is tolerated.
  std::optional<Violation> first_violation_from(double t, const Trajectory& accepted) const;

private:
  std::shared_ptr<const referee::ObstacleCells> cells_;
  Robot robot_;
  RefereeOptions options_;
  Pose frame_;
};

}  // namespace fourwis
