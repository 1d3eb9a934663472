#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"

namespace fourwis::can
{

/// Throws std::invalid_argument as check(options) and check(robot) do, and where the options ask for more than a drive's
/// numbers can say.
void check(const Robot& robot, const BridgeOptions& options);

}  // namespace fourwis::can
