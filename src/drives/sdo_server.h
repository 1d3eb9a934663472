#pragma once

#include <cstdint>
#include <optional>

#include "fourwis_navigation/can/protocol/frame.h"
#include "fourwis_navigation/drives/object_dictionary.h"

namespace fourwis::drives
{

/// Does what an expedited SDO request to `node` asks for, and gives the reply (CiA 301, 7.2.4). Nothing for a frame
/// that is not eight bytes long and for the client's own abort. Segmented transfers are refused.
std::optional<can::Frame> answer_sdo(ObjectDictionary& dictionary, std::uint8_t node, const can::Frame& request);

/// The reply that refuses `request`.
can::Frame abort_sdo(std::uint8_t node, const can::Frame& request, AbortCode code);

}  // namespace fourwis::drives
