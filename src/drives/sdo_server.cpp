#include "sdo_server.h"

#include "frames.h"

namespace fourwis::drives
{
namespace
{

/// The command specifier: the highest three bits of the first byte.
constexpr int kDownload = 1, kUpload = 2, kAbort = 4;
constexpr std::uint8_t kDownloaded = 0x60, kUploadedExpedited = 0x43, kAborted = 0x80;

ObjectAddress address_of(const can::Frame& request)
{
  return {static_cast<std::uint16_t>(take_bytes(request, 1, 2)), request.data[3]};
}

/// The reply to `request` of this node about the same object.
can::Frame reply_to(const can::Frame& request, std::uint8_t node, std::uint8_t command)
{
  can::Frame reply = request;
  reply.id = cob::kSdoReply + node;
  reply.data[0] = command;
  put_bytes(reply, 4, 4, 0);
  return reply;
}

/// Number of bytes of an expedited download: 4 - n if the bit s is set, otherwise the size of the object.
std::uint8_t size_of(const can::Frame& request, const Object* object)
{
  const std::uint8_t command = request.data[0];
  if ((command & 0x01) != 0) return static_cast<std::uint8_t>(4 - ((command >> 2) & 0x03));
  return object != nullptr ? object->size : 4;
}

AbortCode download(ObjectDictionary& dictionary, const can::Frame& request)
{
  const bool expedited = (request.data[0] & 0x02) != 0;
  if (!expedited) return AbortCode::unknown_command;
  const ObjectAddress address = address_of(request);
  const std::uint8_t size = size_of(request, dictionary.find(address));
  return dictionary.write(address, size, take_bytes(request, 4, size));
}

can::Frame upload(const ObjectDictionary& dictionary, std::uint8_t node, const can::Frame& request)
{
  const AbortCode missing = dictionary.existence(address_of(request));
  if (missing != AbortCode::none) return abort_sdo(node, request, missing);
  const Object& object = *dictionary.find(address_of(request));
  const int unused = 4 - object.size;
  can::Frame reply = reply_to(request, node, static_cast<std::uint8_t>(kUploadedExpedited | unused << 2));
  put_bytes(reply, 4, 4, bytes_of(object));
  return reply;
}

}  // namespace

can::Frame abort_sdo(std::uint8_t node, const can::Frame& request, AbortCode code)
{
  can::Frame reply = reply_to(request, node, kAborted);
  put_bytes(reply, 4, 4, static_cast<std::uint32_t>(code));
  return reply;
}

std::optional<can::Frame> answer_sdo(ObjectDictionary& dictionary, std::uint8_t node, const can::Frame& request)
{
  if (request.size != 8) return std::nullopt;
  switch (request.data[0] >> 5)
  {
    case kDownload:
    {
      const AbortCode code = download(dictionary, request);
      return code == AbortCode::none ? reply_to(request, node, kDownloaded) : abort_sdo(node, request, code);
    }
    case kUpload: return upload(dictionary, node, request);
    case kAbort: return std::nullopt;
    default: return abort_sdo(node, request, AbortCode::unknown_command);
  }
}

}  // namespace fourwis::drives
