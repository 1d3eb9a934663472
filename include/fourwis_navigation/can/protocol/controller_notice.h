#pragma once

#include <cstdint>
#include <optional>

#include "fourwis_navigation/can/protocol/frame.h"

namespace fourwis::can
{

/// The state of a CAN controller in an error frame. The bits are those of linux/can/error.h.
struct ControllerNotice
{
  bool bus_off = false;
  bool restarted = false;  ///< the controller is on the bus again
  bool transmit_timeout = false;
  bool no_acknowledge = false;  ///< no other node acknowledges frames
  bool warning = false;
  bool passive = false;  ///< error-passive: many errors, still working
  bool active = false;   ///< back to normal
  bool receive_overflow = false;
  bool transmit_overflow = false;
  std::uint8_t transmit_errors = 0;  ///< the controller's own counters, 0 where it does not say
  std::uint8_t receive_errors = 0;
};

/// Whether the notice tells a state of the controller. Other notices are about single frames.
bool tells_state(const ControllerNotice& notice);

/// Nothing for a frame that is no error frame.
std::optional<ControllerNotice> decode_notice(const Frame& frame);

}  // namespace fourwis::can
