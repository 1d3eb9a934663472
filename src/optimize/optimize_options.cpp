#include "fourwis_navigation/optimize/optimize_options.h"

#include "fourwis_navigation/model/option_check.h"

namespace fourwis
{

void check(const OptimizeOptions& options)
{
  check_ranges(options);
}

}  // namespace fourwis
