#include "line_faults.h"

#include "frames.h"
#include "sdo_server.h"

namespace fourwis::drives
{
namespace
{

/// Whether the frame has this function code and node.
bool is(const can::Frame& frame, std::uint32_t function, int node)
{
  return is_plain(frame) && frame.id == function + static_cast<std::uint32_t>(node);
}

bool is_process_data(const can::Frame& frame)
{
  return frame.id >= cob::kFirstTransmitPdo && frame.id < cob::kSdoReply;
}

}  // namespace

bool LineFaults::receives(int node, const can::Frame& frame) const
{
  if (has(DriveFaultKind::node_silent, node)) return false;
  const bool drops_requests = has(DriveFaultKind::sdo_abort, node) || has(DriveFaultKind::sdo_silent, node);
  return !(drops_requests && is(frame, cob::kSdoRequest, node));
}

std::optional<can::Frame> LineFaults::abort_reply(int node, const can::Frame& frame) const
{
  const DriveFault* fault = faults_.active(DriveFaultKind::sdo_abort, node);
  if (fault == nullptr || !is(frame, cob::kSdoRequest, node) || frame.size != 8) return std::nullopt;
  return abort_sdo(static_cast<std::uint8_t>(node), frame, static_cast<AbortCode>(fault->value));
}

std::optional<can::Frame> LineFaults::passes(int node, can::Frame frame)
{
  if (has(DriveFaultKind::node_silent, node)) return std::nullopt;
  if (has(DriveFaultKind::heartbeat_lost, node) && is(frame, cob::kHeartbeat, node)) return std::nullopt;
  if (is(frame, cob::kFirstTransmitPdo, node))
  {
    if (has(DriveFaultKind::status_missing, node)) return std::nullopt;
    const auto last = last_status_.find(node);
    if (has(DriveFaultKind::status_frozen, node) && last != last_status_.end()) frame = last->second;
    last_status_[node] = frame;
  }
  if (has(DriveFaultKind::wrong_size, node) && is_process_data(frame) && frame.size > 0) --frame.size;
  return frame;
}

}  // namespace fourwis::drives
