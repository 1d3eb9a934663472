#pragma once

#include <memory>

#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/can/bridge/bridge_report.h"
#include "fourwis_navigation/can/bus/outbox.h"
#include "fourwis_navigation/model/wheels.h"

namespace fourwis::can
{

/// Drives a base over a bus: from wheel commands to frames and from frames to wheel states. It starts the drives. It
/// moves them only after enable() and until the first fault, stops them by itself, and never enables them again by
/// itself. It knows neither a clock nor a bus: time is an argument (monotonic, [s]), frames come in by receive() and
/// leave by the outbox, which the caller flushes after every call. The same calls give the same frames. To be used by
/// one thread. After construction nothing allocates or throws.
class Bridge
{
public:
  /// Throws as the checks of both do, and where options ask for more than a drive's numbers can say.
  Bridge(const Robot& robot, const BridgeOptions& options);
  ~Bridge();

  /// Says whether the bus can be used; false at the beginning.
  void set_link(bool up, double now);

  /// A frame of the bus, error frames included. Frames that are sent in response are in the outbox when it returns.
  void receive(const Frame& frame, double now);

  /// The newest command, and the time `made` from which its timeout counts. While enabled it is sent at once, at most
  /// once in a cycle in addition to the frames of the cycle itself.
  void command(const WheelCommand& command, double made, double now);

  /// While pressed, nothing can be enabled; pressing it stops the base at once.
  void press_emergency_stop(bool pressed, double now);

  // Requests of the operator. Null when it is accepted, otherwise why it is not.
  const char* enable(double now);
  const char* disable(double now);  ///< controlled stop, then the drives are disabled
  const char* clear_faults(double now);

  /// To be called once a cycle, after receive().
  void cycle(double now);

  Outbox& outbox();

  const WheelState& wheels() const;  ///< as of the last cycle
  BridgeReport report() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fourwis::can
