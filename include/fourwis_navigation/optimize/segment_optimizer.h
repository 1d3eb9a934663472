#pragma once

#include <string>
#include <vector>

#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/model/interrupt.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/segment.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/optimize/optimize_options.h"

namespace fourwis
{

class MotionLimits;

/// What is to be solved.
struct SegmentTask
{
  const Segment& segment;    ///< the reference
  const Corridor& corridor;  ///< with a region for each of its intervals
  const Trajectory* previous =
      nullptr;                    ///< where it is not null: as many points, to begin from instead of the reference
  std::vector<char> pinned = {};  ///< the knots at which the robot stops (one per knot, or none)
};

/// Result of one solve. `points` begin at t = 0 and are the solver's knots. They are filled also if it did not
/// converge, so that another solve can start there.
struct SegmentSolution
{
  bool solved = false;
  std::string message;  ///< how the solver ended, for messages
  Trajectory points;
  int iterations = 0;
  double corridor_violation = 0.0;  ///< greatest distance by which a disc centre leaves its region at a knot [m], or
                                    ///< (way / longest way)^2 - 1 of an interval
};

/// The paper's eq. (26) for one segment, on the structured solver and without its penalties:
///   minimise    sum_k h_k + alpha (v_k omega_k)^2 h_k + w_h (h_k - h_ref)^2 + penalty of leaving the corridor
///   subject to  x_{k+1} = F(x_k, u_k)  (Simpson's rule, hard), limits on v, phi, a, omega, h and on each wheel's turning rate,
///               the disc centres at knot k in their regions of the intervals k - 1 and k,
///               no interval much longer than the segment's (elastic),
///               the segment's first and last pose, v = 0 at both.
/// phi starts at the reference's value. At the end it is free, because the wheels are turned at rest between segments.
class SegmentOptimizer
{
public:
  /// Keeps references to robot and options. Throws as their check() does, and unless the reference speed is positive and
  /// finite.
  SegmentOptimizer(const Robot& robot, const OptimizeOptions& options, double reference_speed);

  /// Solves to `tolerance`.
  SegmentSolution solve(const SegmentTask& task, double tolerance, const Interrupt& interrupt) const;

private:
  template <class WheelSpeeds>
  SegmentSolution solve_with(const SegmentTask& task, const MotionLimits& limits, double tolerance,
                             const Interrupt& interrupt) const;

  const Robot& robot_;
  const OptimizeOptions& options_;
  double reference_speed_;
};

}  // namespace fourwis
