#pragma once

#include <memory>

#include "fourwis_navigation/can/bridge/base_protocol.h"
#include "fourwis_navigation/can/bridge/bridge_options.h"

namespace fourwis::can
{

/// The protocol that the options name. `log` must outlive it.
std::unique_ptr<BaseProtocol> make_protocol(const Robot& robot, const BridgeOptions& options, FaultLog& log);

}  // namespace fourwis::can
