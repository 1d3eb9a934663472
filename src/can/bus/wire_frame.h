#pragma once

#include <linux/can.h>

#include "fourwis_navigation/can/protocol/frame.h"

namespace fourwis::can
{

/// The kernel's form of a valid frame.
can_frame to_wire(const Frame& frame);

/// False for data that is no classic frame; then `frame` is not changed.
bool from_wire(const can_frame& wire, Frame& frame);

}  // namespace fourwis::can
