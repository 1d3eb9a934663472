#pragma once

#include <cstdint>
#include <optional>

#include "fourwis_navigation/can/protocol/frame.h"

/// CANopen, CiA 301: reading and writing a node's objects one by one, as far as four bytes suffice (expedited
/// transfer). Pure bytes.
namespace fourwis::can
{

struct ObjectId
{
  std::uint16_t index = 0;
  std::uint8_t sub = 0;

  friend bool operator==(ObjectId a, ObjectId b) { return a.index == b.index && a.sub == b.sub; }
  friend bool operator!=(ObjectId a, ObjectId b) { return !(a == b); }
};

/// Asks `node` to set an object of `size` bytes, 1 to 4; a negative value in two's complement.
Frame encode_sdo_write(int node, ObjectId object, std::uint32_t value, int size);

/// Asks `node` for an object.
Frame encode_sdo_read(int node, ObjectId object);

/// A node's answer to one of these.
struct SdoReply
{
  enum class Kind
  {
    written,
    value,
    abort  ///< it will not; `value` is CiA 301's code of why
  };
  Kind kind = Kind::abort;
  ObjectId object;
  std::uint32_t value = 0;
  int size = 0;  ///< bytes of `value`, 4 where the node does not say
};

/// Nothing for a frame that is no answer, has not 8 bytes, or does not fit into one frame.
std::optional<SdoReply> decode_sdo_reply(const Frame& frame);

// Abort codes.
inline constexpr std::uint32_t kNoSuchObject = 0x06020000, kNoSuchSubIndex = 0x06090011;

/// An abort code in words; "unknown" for one that is not in CiA 301.
const char* sdo_abort_text(std::uint32_t code);

}  // namespace fourwis::can
