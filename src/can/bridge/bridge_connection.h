#pragma once

#include "fourwis_navigation/can/bridge/bridge.h"
#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::can
{

/// A bridge at one end of a bus: what the bus has goes to the bridge, what the bridge has goes to the bus, and a bus
/// that is down is opened again when it comes back. Time is monotonic [s]. No allocation but where a bus is opened.
class BridgeConnection
{
public:
  /// Both must outlive this.
  BridgeConnection(Bridge& bridge, Bus& bus) : bridge_(bridge), bus_(bus) {}

  /// Whenever there may be something to receive or room to send.
  void exchange(double now);

  /// At the cycle's rate.
  void cycle(double now);

  /// After anything else that was asked of the bridge.
  void flush(double now);

  /// Frames wait for room on the bus.
  bool is_blocked() const { return !bridge_.outbox().empty(); }

private:
  void receive(double now);
  void recover(double now);
  void lose(double now);

  Bridge& bridge_;
  Bus& bus_;
  bool up_ = false;
  double next_attempt_ = 0.0;
};

}  // namespace fourwis::can
