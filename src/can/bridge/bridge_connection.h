#pragma once

#include "fourwis_navigation/can/bridge/bridge.h"
#include "fourwis_navigation/can/bus/bus.h"

namespace fourwis::can
{

/// Connects a bridge to one end of a bus. It passes frames in both directions, and opens a bus that is down again when
/// it comes back. Time is monotonic [s]. Nothing allocates, except when a bus is opened.
class BridgeConnection
{
public:
  /// Both must outlive this.
  BridgeConnection(Bridge& bridge, Bus& bus) : bridge_(bridge), bus_(bus) {}

  /// To be called when there may be frames to receive or room to send.
  void exchange(double now);

  /// To be called once a cycle.
  void cycle(double now);

  /// To be called after every other call of the bridge: sends what is in its outbox.
  void flush(double now);

  /// Whether frames wait for room on the bus.
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
