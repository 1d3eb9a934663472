#include "simulation_clock.h"

#include <rosgraph_msgs/Clock.h>

namespace fourwis
{
namespace
{

/// Where a clock of our own begins: zero has a meaning in ROS, and subtracting a tolerance must not become negative.
const ros::Time kBeginning(1000.0);

/// A follower that is further behind than this leaves time out instead of catching up.
const ros::Duration kLate(0.5);

/// Throws ConfigError where the clock is to be published and other nodes would not follow it.
void require_followers(const BaseSimulatorNodeOptions& options)
{
  if (options.publish_clock && !ros::Time::isSimTime())
    throw ConfigError(
        "parameter 'publish_clock' is true, expected false where '/use_sim_time' is not true: no node "
        "would follow that clock");
}

}  // namespace

SimulationClock::SimulationClock(const BaseSimulatorNodeOptions& options, Cycle cycle, Ready ready)
  : period_(1.0 / options.publish_frequency),
    cycle_(std::move(cycle)),
    ready_(std::move(ready)),
    time_(kBeginning)
{
  require_followers(options);
  if (options.publish_clock)
  {
    clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 10);
    wall_timer_ = node_.createWallTimer(ros::WallDuration(period_.toSec() / options.real_time_factor),
                                        [this](const ros::WallTimerEvent&) { on_wall_timer(); });
  }
  else
    timer_ = node_.createTimer(period_, [this](const ros::TimerEvent& event) { follow(event.current_real); });
}

void SimulationClock::on_wall_timer()
{
  if (!ready_(time_)) return;
  time_ += period_;
  rosgraph_msgs::Clock clock;
  clock.clock = time_;
  clock_.publish(clock);
  cycle_(time_);
}

void SimulationClock::follow(const ros::Time& now)
{
  if (now < time_ || now - time_ > kLate) time_ = now - period_;
  for (; now - time_ >= period_; cycle_(time_)) time_ += period_;
}

}  // namespace fourwis
