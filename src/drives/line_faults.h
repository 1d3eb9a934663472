#pragma once

#include <map>
#include <optional>

#include "fault_schedule.h"
#include "fourwis_navigation/can/protocol/frame.h"

namespace fourwis::drives
{

/// The effect of faults on the frames between a working drive and the bus.
class LineFaults
{
public:
  explicit LineFaults(const FaultSchedule& faults) : faults_(faults) {}

  /// Whether the node receives a frame of the bus.
  bool receives(int node, const can::Frame& frame) const;
  /// The answer in place of a node that refuses every request.
  std::optional<can::Frame> abort_reply(int node, const can::Frame& frame) const;
  /// The frame that reaches the bus when the node sends one; nothing if it is lost.
  std::optional<can::Frame> passes(int node, can::Frame frame);

private:
  bool has(DriveFaultKind kind, int node) const { return faults_.active(kind, node) != nullptr; }

  const FaultSchedule& faults_;
  std::map<int, can::Frame> last_status_;
};

}  // namespace fourwis::drives
