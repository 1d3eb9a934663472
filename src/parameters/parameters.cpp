#include "fourwis_navigation/parameters/parameters.h"

#include "parameter_list.h"

namespace fourwis
{

Robot robot_from(const ParameterMap& parameters)
{
  Robot robot = options_from<Robot>(parameters);
  check_configuration(robot);
  return robot;
}

PlannerOptions planner_options_from(const ParameterMap& parameters)
{
  return options_from<PlannerOptions>(parameters);
}

TrackOptions track_options_from(const ParameterMap& parameters)
{
  return options_from<TrackOptions>(parameters);
}

SimulatorOptions simulator_options_from(const ParameterMap& parameters)
{
  return options_from<SimulatorOptions>(parameters);
}

can::BridgeOptions bridge_options_from(const ParameterMap& parameters)
{
  return options_from<can::BridgeOptions>(parameters);
}

}  // namespace fourwis
