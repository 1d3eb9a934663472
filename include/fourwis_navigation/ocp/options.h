#pragma once

#include <functional>

namespace fourwis::ocp
{

/// How the solver proceeds. The defaults are for problems whose variables and costs are of the order of one.
struct Options
{
  double tolerance = 1e-6;             ///< of the error (optimality.h) at which a problem is solved
  double acceptable_tolerance = 1e-4;  ///< at which it is `acceptable` where no further progress is possible
  int max_iterations = 300;
  double initial_barrier = 0.1;  ///< mu at the start; 1e-2 or less for a good guess
  double barrier_factor = 0.2;   ///< mu <- min(barrier_factor mu, mu^barrier_power), not below tolerance / 10
  double barrier_power = 1.5;
  double terminal_regularization = 1e-7;  ///< delta of x_N - goal = delta (nu_new - nu) in each Newton step; the result
                                          ///< does not depend on it, but below 1e-9 the step loses digits
};

/// Throws std::invalid_argument, naming the option, its value and the range, if one is out of range.
void check(const Options& options);

enum class Status
{
  solved,           ///< optimality error within `tolerance`
  acceptable,       ///< no further progress or iterations, but error within `acceptable_tolerance`
  iteration_limit,  ///< the trajectory is the last iterate
  infeasible,       ///< no step reduces the constraints' violation: usually a minimum of it, at least a local one
  stalled,          ///< no step makes progress, or feasibility steps went on without end
  interrupted,      ///< by the caller
  not_finite,       ///< a value or derivative at the start, or a derivative at an iterate, is not a finite number
  invalid_problem   ///< sizes do not fit, lower > upper, NaN, negative weights, nothing between the bounds
};

/// For messages: the enumerator's name.
const char* to_string(Status status);

struct Statistics
{
  int iterations = 0;              ///< Newton steps taken
  int regularizations = 0;         ///< factorisations repeated because a control Hessian was not positive definite
  int corrections = 0;             ///< second-order corrections accepted
  int feasibility_steps = 0;       ///< steps that only reduce the constraints' violation
  double error = 0.0;              ///< optimality error: greatest of stationarity, feasibility, complementarity, scaled
  double infeasibility = 0.0;      ///< greatest violation of an equality or of a row beyond its e_i
  double cost = 0.0;               ///< sum of the l_k and l_N, without elastic penalties
  double elastic_violation = 0.0;  ///< greatest g_i - c_i of the elastic rows; 0 if all are met
};

/// Polled once in each iteration; true stops the solver. May be empty.
using Interrupted = std::function<bool()>;

}  // namespace fourwis::ocp
