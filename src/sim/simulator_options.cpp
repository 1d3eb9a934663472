#include "fourwis_navigation/sim/simulator_options.h"

#include "fourwis_navigation/model/option_check.h"

namespace fourwis
{

void check(const ActuatorOptions& options)
{
  check_ranges(options);
}

void check(const SlipOptions& options)
{
  check_ranges(options);
}

void check(const EncoderOptions& options)
{
  check_ranges(options);
}

void check(const InterlockOptions& options)
{
  check_ranges(options);
}

void check(const SimulatorOptions& options)
{
  check_ranges(options);
}

}  // namespace fourwis
