#include "../ipopt_solver.h"

#include <IpIpoptApplication.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/optimize/optimize_options.h"
#include "ipopt_program.h"

namespace fourwis
{
namespace
{

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::mutex& mutex_of_process()
{
  static std::mutex mutex;
  return mutex;
}

void configure(const IpoptOptions& options, Ipopt::OptionsList& list)
{
  list.SetStringValue("sb", "yes");
  list.SetIntegerValue("print_level", 0);
  list.SetNumericValue("tol", options.tolerance);
  list.SetNumericValue("mu_init", options.initial_barrier);
  list.SetNumericValue("bound_push", options.bound_distance);
  list.SetNumericValue("bound_frac", std::min(0.5, options.bound_distance));
  list.SetNumericValue("slack_bound_push", options.bound_distance);
  list.SetNumericValue("slack_bound_frac", std::min(0.5, options.bound_distance));
  list.SetIntegerValue("max_iter", options.max_iterations);
  // Half the time of the defaults on problems of this structure.
  list.SetIntegerValue("mumps_pivot_order", 0);
  list.SetIntegerValue("min_refinement_steps", 0);
}

NlpStatus status_of(Ipopt::ApplicationReturnStatus status)
{
  switch (status)
  {
    case Ipopt::Solve_Succeeded: return NlpStatus::solved;
    case Ipopt::Solved_To_Acceptable_Level:
    case Ipopt::Feasible_Point_Found: return NlpStatus::acceptable;
    case Ipopt::Infeasible_Problem_Detected: return NlpStatus::infeasible;
    case Ipopt::User_Requested_Stop: return NlpStatus::interrupted;
    case Ipopt::Maximum_Iterations_Exceeded: return NlpStatus::iteration_limit;
    case Ipopt::Not_Enough_Degrees_Of_Freedom:
    case Ipopt::Invalid_Problem_Definition:
    case Ipopt::Invalid_Number_Detected: return NlpStatus::invalid_problem;
    default: return NlpStatus::failed;
  }
}

}  // namespace

bool has_ipopt()
{
  return true;
}

bool is_valid(const Nlp& nlp)
{
  for (std::size_t i = 0; i < nlp.start.size(); ++i)
    if (!(nlp.lower[i] <= nlp.upper[i]) || nlp.lower[i] == kInfinity || nlp.upper[i] == -kInfinity ||
        !std::isfinite(nlp.start[i]))
      return false;
  return !nlp.start.empty() && std::all_of(nlp.elements.begin(), nlp.elements.end(), [](const auto& element) {
    return (element->row_lower.array() <= element->row_upper.array()).all();
  });
}

void check(const IpoptOptions& options)
{
  check_ranges(options);
}

NlpResult solve_on_ipopt(const Nlp& nlp, const IpoptOptions& options, const Interrupt& interrupt)
{
  check(options);
  NlpResult result;
  result.x = nlp.start;
  if (!is_valid(nlp)) return result;

  const std::lock_guard<std::mutex> lock(mutex_of_process());
  const Ipopt::SmartPtr<IpoptProgram> program = new IpoptProgram(nlp, interrupt);
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  configure(options, *application->Options());
  if (application->Initialize("") != Ipopt::Solve_Succeeded)
  {
    result.status = NlpStatus::failed;
    return result;
  }
  result.status = status_of(application->OptimizeTNLP(Ipopt::GetRawPtr(program)));
  result.x = program->x();
  result.iterations = program->iterations();
  return result;
}

}  // namespace fourwis
