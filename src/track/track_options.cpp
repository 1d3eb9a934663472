#include "fourwis_navigation/track/track_options.h"

#include <algorithm>

#include "forecast.h"
#include "fourwis_navigation/model/option_check.h"

namespace fourwis
{

void check(const TrackOptions& options)
{
  check_ranges(options);
  require_in({2.0, 5000.0}, "horizon * controller_frequency", options.horizon * options.controller_frequency);
  const double remembered = options.command_latency + std::max(options.pose_timeout, options.wheel_state_timeout);
  require_in({0.0, Forecast::kSteps},
             "(command_latency + the greater of pose_timeout and wheel_state_timeout) * controller_frequency",
             remembered * options.controller_frequency);
}

}  // namespace fourwis
