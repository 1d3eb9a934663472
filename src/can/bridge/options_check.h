#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"

namespace fourwis::can
{

/// Throws std::invalid_argument where options contradict each other or themselves, or ask for more than a drive's
/// numbers can say, naming key and value.
void check(const Robot& robot, const BridgeOptions& options);

}  // namespace fourwis::can
