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
};

struct NlpResult
{
  NlpStatus status = NlpStatus::invalid_problem;
  std::vector<double> x;  ///< the last iterate; the start if there was none
  int iterations = 0;
};

/// Solves on Ipopt with exact second derivatives. Only one program in the process is solved at a time, others wait:
/// MUMPS, on which Ipopt depends in Debian, is not thread-safe.
NlpResult solve_on_ipopt(const Nlp& nlp, const IpoptOptions& options, const Interrupt& interrupt);

}  // namespace fourwis
