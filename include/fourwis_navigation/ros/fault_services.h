#pragma once

#include <functional>
#include <map>
#include <string>

#include <ros/node_handle.h>
#include <ros/service_server.h>
#include <std_srvs/Trigger.h>

#include "fourwis_navigation/InjectFault.h"
#include "fourwis_navigation/ros/base_topics.h"
#include "fourwis_navigation/ros/ideal_localization.h"
#include "fourwis_navigation/sim/base_simulator.h"

namespace fourwis
{

/// `~inject_fault` and `~clear_faults` of the simulated robot.
class FaultServices
{
public:
  /// All must outlive this.
  FaultServices(BaseSimulator& simulator, BaseTopics& base, IdealLocalization& localization);

private:
  void inject(const fourwis_navigation::InjectFault::Request& request);
  void advertise();
  void break_wheel(WheelFault::Kind kind, int wheel);
  void jump(const Pose& by);
  void clear();

  BaseSimulator& simulator_;
  BaseTopics& base_;
  IdealLocalization& localization_;
  BaseTopics::Silence silent_;
  std::map<std::string, std::function<void(const fourwis_navigation::InjectFault::Request&)>> faults_;  ///< by kind
  ros::ServiceServer inject_, clear_;
};

}  // namespace fourwis
