#pragma once

#include "direct_base.h"
#include "direct_base_faults.h"
#include "fault_services.h"
#include "fourwis_navigation/sim/base_simulator.h"
#include "fourwis_navigation/vehicle/base_link.h"
#include "ideal_localization.h"
#include "simulation_clock.h"

namespace fourwis
{

/// The simulator's node without a bus: a base, a localisation that knows where it really is, and the time in which this
/// happens. Spin it with one thread.
class SimulatedRobot
{
public:
  /// Throws ConfigError where it is to publish a clock that no node follows.
  explicit SimulatedRobot(const BaseSimulatorParameters& parameters);

private:
  void place(const Pose& pose);  ///< of base_link
  void cycle(const ros::Time& end);

  const double period_;  ///< of a cycle [s]
  const BaseLink base_link_;
  BaseSimulator simulator_;
  DirectBase base_;
  IdealLocalization localization_;
  DirectBaseFaults faults_;
  FaultServices fault_services_;
  SimulationClock clock_;  ///< last: calls for the first cycle when all else is there
};

}  // namespace fourwis
