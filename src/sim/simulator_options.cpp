#include "fourwis_navigation/sim/simulator_options.h"

#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/vehicle/alignment.h"

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

void check(const Robot& robot, const SimulatorOptions& options)
{
  check(robot);
  check(options);
  const InterlockOptions& interlock = options.interlock;
  check_alignment_timeout(robot, "alignment_timeout", interlock.alignment_timeout,
                          interlock.aligned_time + options.actuators.steering_lag);
}

}  // namespace fourwis
