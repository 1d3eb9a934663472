#pragma once

#include <functional>
#include <map>
#include <string>

#include "base_topics.h"
#include "fourwis_navigation/InjectFault.h"
#include "fourwis_navigation/sim/base_simulator.h"
#include "ideal_localization.h"

namespace fourwis
{

/// What can go wrong with the simulated base without a bus, its topics and its localisation.
class DirectBaseFaults
{
public:
  /// All must outlive this.
  DirectBaseFaults(BaseSimulator& simulator, BaseTopics& base, IdealLocalization& localization);

  /// Throws ConversionError for a fault that it does not know.
  void inject(const fourwis_navigation::InjectFault::Request& request);
  void clear();

private:
  void break_wheel(WheelFault::Kind kind, int wheel);
  void jump(const Pose& by);

  BaseSimulator& simulator_;
  BaseTopics& base_;
  IdealLocalization& localization_;
  BaseTopics::Silence silent_;
  std::map<std::string, std::function<void(const fourwis_navigation::InjectFault::Request&)>> faults_;  ///< by kind
};

}  // namespace fourwis
