#pragma once

#include <cstdint>
#include <optional>

#include "fourwis_navigation/can/protocol/frame.h"

/// CANopen, CiA 301: reading and writing single objects of a node, of up to four bytes (expedited transfer). Pure
/// bytes.
namespace fourwis::can
{

struct ObjectId
{
  std::uint16_t index = 0;
  std::uint8_t sub = 0;

  friend bool operator==(ObjectId a, ObjectId b) { return a.index == b.index && a.sub == b.sub; }
  friend bool operator!=(ObjectId a, ObjectId b) { return !(a == b); }
};

/// Requests `node` to set an object of `size` bytes, 1 to 4. A negative value is in two's complement.
Frame encode_sdo_write(int node, ObjectId object, std::uint32_t value, int size);

/// Requests the value of an object from `node`.
Frame encode_sdo_read(int node, ObjectId object);

/// The answer of a node to one of these requests.
struct SdoReply
{
  enum class Kind
  {
    written,
    value,
    abort  ///< the request is refused; `value` is the abort code of CiA 301
  };
  Kind kind = Kind::abort;
  ObjectId object;
  std::uint32_t value = 0;
  int size = 0;  ///< bytes of `value`; 4 if the node does not say
};

/// Nothing for a frame that is no answer or has not 8 bytes, and for an answer that takes more than one frame.
std::optional<SdoReply> decode_sdo_reply(const Frame& frame);

// Abort codes.
inline constexpr std::uint32_t kNoSuchObject = 0x06020000, kNoSuchSubIndex = 0x06090011;

/// An abort code in words; "unknown" for one that is not in CiA 301.
const char* sdo_abort_text(std::uint32_t code);

}  // namespace fourwis::can
