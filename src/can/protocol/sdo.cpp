#include "fourwis_navigation/can/protocol/sdo.h"

#include "bytes.h"
#include "fourwis_navigation/can/protocol/cia301.h"

namespace fourwis::can
{
namespace
{

constexpr std::uint8_t kWriteRequest = 0x23, kReadRequest = 0x40, kWritten = 0x60, kValue = 0x43, kAbort = 0x80;
/// An expedited transfer without indication of the size.
constexpr std::uint8_t kValueOfUnknownSize = 0x42;
/// The number of unused bytes of the four, in the command byte.
constexpr int kUnusedShift = 2;
constexpr std::uint8_t kUnusedMask = 0x3 << kUnusedShift;

Frame request(int node, std::uint8_t command, ObjectId object)
{
  Frame frame;
  frame.id = cob_id(Service::sdo_request, node);
  frame.size = 8;
  frame.data[0] = command;
  put_little_endian(object.index, &frame.data[1]);
  frame.data[3] = object.sub;
  return frame;
}

/// The part that all answers have in common.
SdoReply reply(SdoReply::Kind kind, const Frame& frame)
{
  return {kind, {get_little_endian<std::uint16_t>(&frame.data[1]), frame.data[3]}, 0, 0};
}

SdoReply reply_with_value(SdoReply::Kind kind, const Frame& frame, int size)
{
  SdoReply answer = reply(kind, frame);
  answer.size = size;
  answer.value = get_little_endian<std::uint32_t>(&frame.data[4]);
  if (size < 4) answer.value &= (1u << (8 * size)) - 1u;
  return answer;
}

}  // namespace

Frame encode_sdo_write(int node, ObjectId object, std::uint32_t value, int size)
{
  const int unused = 4 - size;
  Frame frame = request(node, static_cast<std::uint8_t>(kWriteRequest | unused << kUnusedShift), object);
  if (size < 4) value &= (1u << (8 * size)) - 1u;
  put_little_endian(value, &frame.data[4]);
  return frame;
}

Frame encode_sdo_read(int node, ObjectId object)
{
  return request(node, kReadRequest, object);
}

std::optional<SdoReply> decode_sdo_reply(const Frame& frame)
{
  if (frame.size != 8 || address_of(frame).service != Service::sdo_reply) return std::nullopt;
  const std::uint8_t command = frame.data[0];
  if (command == kWritten) return reply(SdoReply::Kind::written, frame);
  if (command == kAbort) return reply_with_value(SdoReply::Kind::abort, frame, 4);
  if (command == kValueOfUnknownSize) return reply_with_value(SdoReply::Kind::value, frame, 4);
  if ((command & ~kUnusedMask) != kValue) return std::nullopt;
  return reply_with_value(SdoReply::Kind::value, frame, 4 - ((command & kUnusedMask) >> kUnusedShift));
}

const char* sdo_abort_text(std::uint32_t code)
{
  switch (code)
  {
    case 0x05030000: return "toggle bit not alternated";
    case 0x05040000: return "protocol timed out";
    case 0x05040001: return "unknown command";
    case 0x06010000: return "access not supported";
    case 0x06010001: return "the object can only be written";
    case 0x06010002: return "the object can only be read";
    case kNoSuchObject: return "no such object";
    case 0x06040041: return "the object cannot be mapped";
    case 0x06040042: return "the PDO would be too long";
    case 0x06040043: return "incompatible parameter";
    case 0x06060000: return "hardware error";
    case 0x06070010: return "wrong size";
    case 0x06070012: return "too long";
    case 0x06070013: return "too short";
    case kNoSuchSubIndex: return "no such sub-index";
    case 0x06090030: return "value out of range";
    case 0x06090031: return "value too high";
    case 0x06090032: return "value too low";
    case 0x08000000: return "general error";
    case 0x08000020: return "cannot be stored";
    case 0x08000021: return "local control forbids it";
    case 0x08000022: return "not in this state of the device";
    default: return "unknown";
  }
}

}  // namespace fourwis::can
