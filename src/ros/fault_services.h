#pragma once

#include <functional>

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/Trigger.h>

#include "fourwis_navigation/InjectFault.h"

namespace fourwis
{

/// `~inject_fault` and `~clear_faults` of a simulated robot.
class FaultServices
{
public:
  /// Throws ConversionError for a fault that it does not know.
  using Inject = std::function<void(const fourwis_navigation::InjectFault::Request&)>;

  FaultServices(Inject inject, std::function<void()> clear);

private:
  ros::NodeHandle node_{"~"};
  ros::ServiceServer inject_, clear_;
};

}  // namespace fourwis
