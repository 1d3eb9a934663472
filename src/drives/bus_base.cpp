#include "fourwis_navigation/drives/bus_base.h"

#include <algorithm>

namespace fourwis::drives
{

BusBase::BusBase(const std::string& bus, const Robot& robot, const can::BridgeOptions& bridge,
                 const SimulatorOptions& simulator)
  : bus_(can::open_bus(bus)),
    drives_(*bus_, robot, bridge, simulator)
{}

void BusBase::advance(double now)
{
  const double passed = now - time_.value_or(now);
  time_ = now;
  drives_.advance(std::clamp(passed, 0.0, kMostCaughtUp));
}

}  // namespace fourwis::drives
