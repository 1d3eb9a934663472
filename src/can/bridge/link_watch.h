#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/can/bridge/faults.h"
#include "fourwis_navigation/can/bus/outbox.h"
#include "fourwis_navigation/can/protocol/controller_notice.h"
#include "steady.h"

namespace fourwis::can
{

/// Supervises whether frames can be sent: the interface is up, the controller is on the bus, and the queue of frames
/// shrinks within `feedback_timeout`.
class LinkWatch
{
public:
  /// `log` must outlive this.
  LinkWatch(const BridgeOptions& options, FaultLog& log) : log_(log), blocked_(options.feedback_timeout) {}

  void set_up(bool up, double now);
  void receive(const Frame& frame, double now);
  /// Once a cycle, before new frames are put into the outbox. Before the drives are switched on, no node acknowledges
  /// frames and the queue does not shrink: that is no fault of the link.
  void supervise(const Outbox& outbox, double now);

  bool usable() const { return up_ && !notice_.bus_off; }
  const ControllerNotice& notice() const { return notice_; }

private:
  void take(const ControllerNotice& notice, double now);

  FaultLog& log_;
  Steady blocked_;
  std::uint64_t sent_ = 0;
  bool up_ = false;
  bool heard_ = false;  ///< a frame has been received since the interface is up
  ControllerNotice notice_;
};

}  // namespace fourwis::can
