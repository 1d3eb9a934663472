#include "fourwis_navigation/track/track_options.h"

#include <algorithm>

#include "forecast.h"
#include "fourwis_navigation/model/option_check.h"
#include "fourwis_navigation/model/sentence.h"
#include "fourwis_navigation/vehicle/alignment.h"

namespace fourwis
{
namespace
{

void check_correction_speed(const char* limit, double greatest, const TrackOptions& options)
{
  if (options.correction_speed > greatest)
    reject_option("correction_speed", to_text(options.correction_speed),
                  joined("at most '", limit, "' of the robot (", to_text(greatest), " m/s)"));
}

}  // namespace

void check(const TrackOptions& options)
{
  check_ranges(options);
  require_in({2.0, 5000.0}, "horizon * controller_frequency", options.horizon * options.controller_frequency);
  const double remembered = options.command_latency + std::max(options.pose_timeout, options.wheel_state_timeout);
  require_in({0.0, Forecast::kSteps},
             "(command_latency + the greater of pose_timeout and wheel_state_timeout) * controller_frequency",
             remembered * options.controller_frequency);
}

void check(const Robot& robot, const TrackOptions& options)
{
  check(robot);
  check(options);
  check_alignment_timeout(robot, "alignment_timeout", options.alignment_timeout,
                          options.command_latency + options.steering_lag);
  check_correction_speed("max_speed", robot.max_speed, options);
  check_correction_speed("wheel_max_speed", robot.wheel_max_speed, options);
}

}  // namespace fourwis
