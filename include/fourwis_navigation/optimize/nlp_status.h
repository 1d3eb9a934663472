#pragma once

namespace fourwis
{

/// How a nonlinear program ended on Ipopt.
enum class NlpStatus
{
  solved,           ///< to the tolerance asked for
  acceptable,       ///< no further progress, within Ipopt's looser tolerance
  iteration_limit,  ///< the result is the last iterate, also for the next three
  infeasible,       ///< the constraints' violation has a (local) minimum above zero
  failed,           ///< no step makes progress
  interrupted,      ///< by the caller
  invalid_problem   ///< sizes do not fit, a bound is NaN or above its opposite, a value at the start is not finite
};

/// For messages: the enumerator's name.
inline const char* to_string(NlpStatus status)
{
  switch (status)
  {
    case NlpStatus::solved: return "solved";
    case NlpStatus::acceptable: return "acceptable";
    case NlpStatus::iteration_limit: return "iteration_limit";
    case NlpStatus::infeasible: return "infeasible";
    case NlpStatus::failed: return "failed";
    case NlpStatus::interrupted: return "interrupted";
    case NlpStatus::invalid_problem: return "invalid_problem";
  }
  return "";
}

inline bool is_solved(NlpStatus status)
{
  return status == NlpStatus::solved || status == NlpStatus::acceptable;
}

}  // namespace fourwis
