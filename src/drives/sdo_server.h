#pragma once

#include <cstdint>
#include <optional>

#include "fourwis_navigation/can/protocol/frame.h"
#include "fourwis_navigation/drives/object_dictionary.h"

namespace fourwis::drives
{

/// Carries out an expedited SDO request to `node` and returns the reply (CiA 301, 7.2.4). Returns nothing for a frame
/// that is not eight bytes long and for an abort of the client. Segmented transfers are refused.
std::optional<can::Frame> answer_sdo(ObjectDictionary& dictionary, std::uint8_t node, const can::Frame& request);

/// The reply that refuses `request`.
can::Frame abort_sdo(std::uint8_t node, const can::Frame& request, AbortCode code);

}  // namespace fourwis::drives
