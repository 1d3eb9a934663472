#pragma once

#include <functional>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/timer.h>
#include <ros/wall_timer.h>

#include "fourwis_navigation/parameters/node_parameters.h"

namespace fourwis
{

/// Calls for the simulation's cycles: in wall-clock time, or in a time of its own that it publishes on
/// /clock.
class SimulationClock
{
public:
  /// Lets one cycle pass that ends at this time.
  using Cycle = std::function<void(const ros::Time&)>;
  /// Whether the next cycle may come; asked only where the clock is published.
  using Ready = std::function<bool(const ros::Time& now)>;

  /// Throws ConfigError where it is to publish a clock that no node follows.
  SimulationClock(const BaseSimulatorNodeOptions& options, Cycle cycle, Ready ready);

private:
  void on_wall_timer();
  void follow(const ros::Time& now);

  const ros::Duration period_;
  const Cycle cycle_;
  const Ready ready_;
  ros::Time time_;  ///< end of the last cycle
  ros::NodeHandle node_;
  ros::Publisher clock_;
  ros::WallTimer wall_timer_;
  ros::Timer timer_;
};

}  // namespace fourwis
