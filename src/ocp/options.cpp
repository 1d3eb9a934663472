#include "fourwis_navigation/ocp/options.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace fourwis::ocp
{
namespace
{

/// least < value < limit
void check(const char* name, double value, double least, double limit)
{
  if (value > least && value < limit) return;
  throw std::invalid_argument("ocp option " + std::string(name) + " = " + std::to_string(value) +
                              ": must lie between " + std::to_string(least) + " and " + std::to_string(limit));
}

}  // namespace

void check(const Options& options)
{
  check("tolerance", options.tolerance, 0.0, 1e3);
  check("acceptable_tolerance", options.acceptable_tolerance, 0.0, 1e3);
  check("max_iterations", options.max_iterations, -1, 1e6);
  check("initial_barrier", options.initial_barrier, 0.0, 1e3);
  check("barrier_factor", options.barrier_factor, 0.0, 1.0);
  check("barrier_power", options.barrier_power, 1.0, 2.0);
  check("terminal_regularization", options.terminal_regularization, 0.0, 1.0);
}

const char* to_string(Status status)
{
  switch (status)
  {
    case Status::solved: return "solved";
    case Status::acceptable: return "acceptable";
    case Status::iteration_limit: return "iteration_limit";
    case Status::infeasible: return "infeasible";
    case Status::stalled: return "stalled";
    case Status::interrupted: return "interrupted";
    case Status::not_finite: return "not_finite";
    case Status::invalid_problem: return "invalid_problem";
  }
  return "";
}

}  // namespace fourwis::ocp
