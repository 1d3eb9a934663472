#pragma once

#include <cstddef>
#include <vector>

#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/model/mode.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/segment.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/ocp/model.h"
#include "fourwis_navigation/ocp/problem.h"
#include "fourwis_navigation/optimize/optimize_options.h"
#include "fourwis_navigation/optimize/segment_optimizer.h"
#include "fourwis_navigation/optimize/simpson.h"
#include "motion_limits.h"
#include "wheel_rate_rows.h"
#include "wheel_speed_rows.h"

namespace fourwis
{

/// A disc centre has to stay in a half-plane: (a, b) (p + R(theta) o) <= c.
struct DiscRow
{
  HalfPlane plane;
  Point2 centre;  ///< o, on the body [m]
};

/// The functions of a segment's problem, x = (x, y, theta, v, phi), u = (a, omega, h). WheelSpeeds is WheelSpeedRows, or
/// NoWheelSpeedRows for wheels that are always fast enough.
template <class WheelSpeeds>
struct SegmentModel : ocp::ModelBase<5, 3, 3, WheelRateRows::kRows + 1 + WheelSpeeds::kRows>
{
  using Base = ocp::ModelBase<5, 3, 3, WheelRateRows::kRows + 1 + WheelSpeeds::kRows>;
  using typename Base::Control;
  using typename Base::Derivatives;
  using typename Base::Gradients;
  using typename Base::RowHessian;
  using typename Base::RowPoint;
  using typename Base::State;
  using typename Base::Value;

  SegmentModel(const Robot& robot, Mode mode)
    : dynamics(robot, mode),
      wheel_rates(robot, mode),
      wheel_speeds(robot, mode)
  {}

  void evaluate(std::size_t k, const State& x, const Control& u, const State& next, Value& value) const;
  void differentiate(std::size_t k, const State& x, const Control& u, const State& lambda, Derivatives& d) const;
  void rows(std::size_t k, const RowPoint& q, ocp::RowValues values) const;
  void differentiate_rows(std::size_t k, const RowPoint& q, ocp::RowMultipliers y, Gradients gradients,
                          RowHessian& hessian) const;

  /// How far C, the centre of the wheels, moves within an interval [m].
  static double way_of(const RowPoint& q) { return q[7] * (q[3] + 0.5 * q[5] * q[7]); }
  void differentiate_way(const RowPoint& q, double y, Gradients& gradients, RowHessian& hessian) const;

  SimpsonDynamics dynamics;
  static constexpr int kWayRow = WheelRateRows::kRows, kSpeedRows = kWayRow + 1;

  WheelRateRows wheel_rates;  ///< the first rows of each interval
  double reach = 1.0;         ///< most that C moves within an interval [m]: the row after them
  WheelSpeeds wheel_speeds;   ///< the rows after that
  double alpha = 0.0, interval_weight = 0.0;
  std::vector<double> h_ref;           ///< of each interval [s]
  std::vector<DiscRow> disc_rows;      ///< stage by stage
  std::vector<std::size_t> first_row;  ///< of each stage in disc_rows
};

/// One segment's problem as both solvers see it.
template <class WheelSpeeds>
struct SegmentProblem
{
  SegmentModel<WheelSpeeds> model;
  ocp::Problem<5, 3> numbers;
};

template <class WheelSpeeds>
SegmentProblem<WheelSpeeds> segment_problem(const SegmentTask& task, const Robot& robot, const OptimizeOptions& options,
                                            const MotionLimits& limits, double reference_speed);

/// The reference driven at the reference speed, where the wheels can do that, paper eq. (21); `h_ref` seconds for each
/// interval.
ocp::Trajectory<5, 3> reference_guess(const Segment& segment, const MotionLimits& limits,
                                      const std::vector<double>& h_ref);

/// The solver's variables from the points of an earlier solution, and back.
ocp::Trajectory<5, 3> guess_from(const Trajectory& points);
Trajectory points_of(const ocp::Trajectory<5, 3>& trajectory, Mode mode);

}  // namespace fourwis
