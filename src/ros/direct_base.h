#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>

#include "base_topics.h"
#include "fourwis_navigation/WheelCommands.h"
#include "fourwis_navigation/sim/base_simulator.h"

namespace fourwis
{

/// The simulated base without a bus: what comes on `wheel_commands` goes to the simulated wheels, and what these do is
/// published as a bridge would.
class DirectBase
{
public:
  /// `simulator` must outlive this.
  DirectBase(const BaseSimulatorParameters& parameters, BaseSimulator& simulator);

  /// `stamp`: the simulator's present.
  void publish(const ros::Time& stamp);

  /// Whether the controller has answered all it is asked until `now`: its newest command is younger than the lockstep's
  /// period, or none has come for so long that the simulation goes on without.
  bool answered(const ros::Time& now) const;

  BaseTopics& topics() { return topics_; }

private:
  void on_command(const fourwis_navigation::WheelCommands& message);

  const double lockstep_period_;  ///< [s]
  BaseSimulator& simulator_;
  BaseTopics topics_;
  ros::Time commanded_;  ///< stamp of the newest command
  ros::WallTime heard_;  ///< when it came
  ros::NodeHandle node_;
  ros::Subscriber wheel_commands_;
};

}  // namespace fourwis
