#pragma once

#include "fourwis_navigation/model/corridor.h"
#include "fourwis_navigation/model/interrupt.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/segment.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/optimize/nlp_status.h"

namespace fourwis
{

struct PaperOptions
{
  double steering_comfort = 0.1;  ///< alpha, weight of (v omega)^2 over time
  double penalty = 1e6;           ///< alpha_penalty, weight of psi
  double tolerance = 1e-6;        ///< of Ipopt
  int max_iterations = 500;       ///< of Ipopt

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("steering_comfort", o.steering_comfort, 0.0, 1e6);
    row("penalty", o.penalty, 1.0, 1e12);
    row("tolerance", o.tolerance, 1e-12, 1.0);
    row("max_iterations", o.max_iterations, 0, 1e6);
  }
};

/// Throws std::invalid_argument naming key, value and range.
void check(const PaperOptions& options);

/// Result of one solve. `points` begin at t = 0 and are the N + 1 knots, T/N apart. They are the solver's last iterate,
/// also if it did not converge. There are none if the problem is invalid.
struct PaperSolution
{
  NlpStatus status = NlpStatus::invalid_problem;
  Trajectory points;
  double infeasibility = 0.0;  ///< psi of `points`
  int iterations = 0;

  double duration() const { return points.empty() ? 0.0 : points.back().t; }  ///< T [s]
};

/// The paper's eq. (26) for one segment, its formulation kept for comparison: with dt = T/N, states
/// x = (x, y, theta, v, phi), controls u = (a, omega) and free disc centres p,
///   minimise    T + alpha sum_k (v_k omega_k)^2 dt + alpha_penalty psi,   psi = J_dyn + J_geom,
///               J_dyn  = sum_k |x_{k+1} - x_k - (f(x_k) + B u_k) dt|^2                      (Euler's rule, 0 <= k < N)
///               J_geom = sum_k (|p_k^f - O_f(x_k)|^2 + |p_k^r - O_r(x_k)|^2) dt             (0 < k < N)
///   subject to  p_k in the boxes of knot k, limits on v, phi, a, omega,
///               first and last pose and phi as in the reference, v = 0 at both.
///
/// Deviations from the paper, none of which changes the optimum:
///  - the residuals d_k = x_{k+1} - ... and g_k = p_k - O(x_k) are variables (the lifted form): the weight 1e6 stands
///    on their squares alone instead of on every product of derivatives, which Ipopt solves more often;
///  - theta is continuous, and fixed at the end: the gradients of sin theta_N = s and cos theta_N = c are parallel, so
///    that the paper's pair of constraints is rank-deficient;
///  - no centres at the ends: poses are fixed there.
/// Only the limits of C, the centre of the wheels, and of the equivalent wheel count, as in the paper, not those of the
/// single wheels.
class PaperOptimizer
{
public:
  /// Keeps a reference to the robot. Throws as the checks do, and unless the reference speed is positive and finite.
  PaperOptimizer(const Robot& robot, const PaperOptions& options, double reference_speed);

  /// Solves from the reference, driven in T = L / v_ref (21), or from `previous`, with as many points, where it is not
  /// null. Never throws on any segment and boxes. Throws std::logic_error where has_ipopt() is false.
  PaperSolution solve(const Segment& segment, const BoxCorridor& boxes, const Trajectory* previous,
                      const Interrupt& interrupt) const;

private:
  const Robot& robot_;
  const PaperOptions options_;
  double reference_speed_;
};

}  // namespace fourwis
