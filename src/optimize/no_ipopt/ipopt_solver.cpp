// In place of the folder ipopt/ where the library is built without Ipopt.

#include "../ipopt_solver.h"

#include <stdexcept>

#include "fourwis_navigation/optimize/optimize_options.h"

namespace fourwis
{

bool has_ipopt()
{
  return false;
}

NlpResult solve_on_ipopt(const Nlp&, const IpoptOptions&, const Interrupt&)
{
  throw std::logic_error("solve_on_ipopt() was called, but has_ipopt() is false");
}

}  // namespace fourwis
