#pragma once

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/can/bridge/faults.h"
#include "fourwis_navigation/can/bus/outbox.h"
#include "fourwis_navigation/can/protocol/controller_notice.h"
#include "steady.h"

namespace fourwis::can
{

/// Whether frames can leave: the interface is up, the controller is on the bus, the queue moves (within
/// `feedback_timeout`).
class LinkWatch
{
public:
  /// `log` must outlive this.
  LinkWatch(const BridgeOptions& options, FaultLog& log) : log_(log), blocked_(options.feedback_timeout) {}

  void set_up(bool up, double now);
  void receive(const Frame& frame, double now);
  /// Once a cycle, before anything new is put into the outbox. Where nobody is there to acknowledge, before the drives
  /// are switched on, no queue moves: that is no fault of the link.
  void supervise(const Outbox& outbox, double now);

  bool usable() const { return up_ && !notice_.bus_off; }
  const ControllerNotice& notice() const { return notice_; }

private:
  void take(const ControllerNotice& notice, double now);

  FaultLog& log_;
  Steady blocked_;
  std::uint64_t sent_ = 0;
  bool up_ = false;
  bool heard_ = false;  ///< somebody has sent something since the interface is up
  ControllerNotice notice_;
};

}  // namespace fourwis::can
