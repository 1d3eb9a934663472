#pragma once

#include <cstdint>

#include "drive_objects.h"
#include "fourwis_navigation/can/protocol/frame.h"

namespace fourwis::drives
{

/// EMCY error codes that a drive detects by itself.
inline constexpr std::uint16_t kPdoTooShort = 0x8210, kHeartbeatLost = 0x8130, kFollowingErrorCode = 0x8611;

/// Writes an error into 1001, 1003 and 603F. Returns its emergency message.
can::Frame record_error(ObjectDictionary& dictionary, std::uint8_t node, std::uint16_t code);

/// Clears all errors. Returns the emergency message of it.
can::Frame clear_errors(ObjectDictionary& dictionary, std::uint8_t node);

}  // namespace fourwis::drives
