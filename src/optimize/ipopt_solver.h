#pragma once

#include <vector>

#include "fourwis_navigation/model/interrupt.h"
#include "fourwis_navigation/optimize/nlp_status.h"
#include "nlp.h"

namespace fourwis
{

struct IpoptOptions
{
  double tolerance = 1e-6;
  double initial_barrier = 1e-2;  ///< less for a start close to the solution
  double bound_distance = 1e-2;   ///< the start is moved at least so far away from bounds, likewise
  int max_iterations = 500;

  /// The table of the options; see model/option_check.h.
  template <class Self, class Row>
  static void describe(Self& o, Row& row)
  {
    row("tolerance", o.tolerance, 1e-16, 1.0);
    row("initial_barrier", o.initial_barrier, 1e-16, 1e3);
    row("bound_distance", o.bound_distance, 1e-16, 0.5);
    row("max_iterations", o.max_iterations, 0, 1e6);
  }
};

/// Throws std::invalid_argument naming key, value and range.
void check(const IpoptOptions& options);

struct NlpResult
{
  NlpStatus status = NlpStatus::invalid_problem;
  std::vector<double> x;  ///< the last iterate; the start if there was none
  int iterations = 0;
};

/// Solves on Ipopt with exact second derivatives. Only one program in the process is solved at a time, and others wait,
/// because MUMPS, which Ipopt uses in Debian, is not thread-safe. Throws as check() does.
NlpResult solve_on_ipopt(const Nlp& nlp, const IpoptOptions& options, const Interrupt& interrupt);

}  // namespace fourwis
