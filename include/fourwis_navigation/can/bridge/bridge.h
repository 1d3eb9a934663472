#pragma once

#include <memory>

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/can/bridge/bridge_report.h"
#include "fourwis_navigation/can/bus/outbox.h"
#include "fourwis_navigation/model/wheels.h"

namespace fourwis::can
{

/// Drives a base over a bus: from wheel commands to frames and from frames to wheel states. Starts the drives, moves
/// them only between enable() and whatever goes wrong first, stops them by itself, and never starts them again by
/// itself. Knows neither a clock nor a bus: time is an argument (monotonic, [s]), frames come in by receive() and
/// leave by the outbox, which is to be flushed after every call. The same calls give the same frames. One thread;
/// after construction nothing allocates or throws.
class Bridge
{
public:
  /// Throws std::invalid_argument where options contradict each other, naming them.
  Bridge(const Robot& robot, const BridgeOptions& options);
  ~Bridge();

  /// The bus can be used, or cannot; false at the beginning.
  void set_link(bool up, double now);

  /// A frame of the bus, error frames included. What it makes necessary is in the outbox at once.
  void receive(const Frame& frame, double now);

  /// The newest command, and when it was made: its timeout counts from then. Sent at once while enabled, at most once
  /// a cycle beside the cycle's own.
  void command(const WheelCommand& command, double made, double now);

  /// While pressed, nothing can be enabled; pressing it stops the base at once.
  void press_emergency_stop(bool pressed, double now);

  // What a person asks for. Null when it is accepted, otherwise why it is not.
  const char* enable(double now);
  const char* disable(double now);  ///< controlled stop, then the drives are disabled
  const char* clear_faults(double now);

  /// To be called at the cycle's rate, after what was received.
  void cycle(double now);

  Outbox& outbox();

  const WheelState& wheels() const;  ///< as of the last cycle
  BridgeReport report() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fourwis::can
