#include "fourwis_navigation/can/protocol/cia301.h"

#include <algorithm>

#include "bytes.h"

namespace fourwis::can
{
namespace
{

constexpr std::uint32_t kNodeMask = 0x7F, kLastStandardId = 0x7FF;
constexpr int kFunctionShift = 7;
/// Function code of both SYNC and emergencies.
constexpr std::uint32_t kSyncFunction = 1;

Service service_of(std::uint32_t function, int node)
{
  if (function == kSyncFunction) return node == 0 ? Service::sync : Service::emergency;
  const bool unused = function == 2 || function == 13 || function == 15;
  // Only NMT has the function code 0.
  if (unused || (function == 0) != (node == 0)) return Service::other;
  return static_cast<Service>(function);
}

Frame frame_of(Service service, int node, std::uint8_t size)
{
  Frame frame;
  frame.id = cob_id(service, node);
  frame.size = size;
  return frame;
}

bool is(const Frame& frame, Service service, std::uint8_t size)
{
  return frame.size == size && address_of(frame).service == service;
}

}  // namespace

Address address_of(const Frame& frame)
{
  if (frame.extended || frame.remote || frame.error || frame.id > kLastStandardId) return {};
  const int node = static_cast<int>(frame.id & kNodeMask);
  const Service service = service_of(frame.id >> kFunctionShift, node);
  return service == Service::other ? Address{} : Address{service, node};
}

std::uint32_t cob_id(Service service, int node)
{
  const std::uint32_t function = service == Service::emergency ? kSyncFunction : static_cast<std::uint32_t>(service);
  return function << kFunctionShift | static_cast<std::uint32_t>(node);
}

const char* to_string(NmtState state)
{
  switch (state)
  {
    case NmtState::boot_up: return "boot-up";
    case NmtState::stopped: return "stopped";
    case NmtState::operational: return "operational";
    case NmtState::pre_operational: return "pre-operational";
  }
  return "unknown";
}

Frame encode_nmt(NmtCommand command, int node)
{
  Frame frame = frame_of(Service::nmt, 0, 2);
  frame.data[0] = static_cast<std::uint8_t>(command);
  frame.data[1] = static_cast<std::uint8_t>(node);
  return frame;
}

Frame encode_sync()
{
  return frame_of(Service::sync, 0, 0);
}

Frame encode_heartbeat(int node, NmtState state)
{
  Frame frame = frame_of(Service::heartbeat, node, 1);
  frame.data[0] = static_cast<std::uint8_t>(state);
  return frame;
}

std::optional<NmtState> decode_heartbeat(const Frame& frame)
{
  if (!is(frame, Service::heartbeat, 1)) return std::nullopt;
  for (const NmtState state : {NmtState::boot_up, NmtState::stopped, NmtState::operational, NmtState::pre_operational})
    if (frame.data[0] == static_cast<std::uint8_t>(state)) return state;
  return std::nullopt;
}

std::optional<Emergency> decode_emergency(const Frame& frame)
{
  if (!is(frame, Service::emergency, 8)) return std::nullopt;
  Emergency emergency;
  emergency.code = get_little_endian<std::uint16_t>(frame.data.data());
  emergency.error_register = frame.data[2];
  std::copy(frame.data.begin() + 3, frame.data.end(), emergency.vendor.begin());
  return emergency;
}

}  // namespace fourwis::can
