#pragma once

#include "fourwis_navigation/can/bridge_options.h"

namespace fourwis::can
{

/// Throws std::invalid_argument where options contradict each other or themselves, naming key and value.
void check(const BridgeOptions& options);

}  // namespace fourwis::can
