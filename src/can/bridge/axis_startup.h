#pragma once

#include "fault_reporter.h"
#include "fourwis_navigation/can/bridge/base_protocol.h"
#include "sdo_client.h"

namespace fourwis::can
{

/// Brings one drive from any state to the exchange of cyclic messages: resets its communication, waits until it boots,
/// reads its identity, writes its settings, starts it.
class AxisStartup
{
public:
  AxisStartup(const Robot& robot, const BridgeOptions& options, const AxisOptions& axis, bool steering,
              FaultReporter report);

  void begin(double now, Outbox& outbox);

  void receive_heartbeat(NmtState state, double now, Outbox& outbox);
  void receive_sdo(const Frame& frame, double now, Outbox& outbox);
  /// To be called when both cyclic messages have come since the start.
  void receive_cyclic();

  /// Once a cycle: repeats requests without an answer, and gives up after the timeouts.
  void supervise(double now, Outbox& outbox);

  StartStep step() const { return step_; }
  bool done() const { return step_ == StartStep::started; }
  /// The set-up is complete: the drive understands our cyclic messages.
  bool is_set_up() const { return step_ >= StartStep::starting; }

private:
  void go_on(double now, Outbox& outbox);
  void enter(StartStep step, double now) { step_ = step, entered_ = now; }
  void send(NmtCommand command, double now, Outbox& outbox);
  void fail(Fault fault, std::uint32_t detail, double now, std::uint32_t object = 0);

  int node_;
  double boot_timeout_;
  SdoScript identification_, configuration_;
  SdoClient client_;
  FaultReporter report_;
  StartStep step_ = StartStep::listening;
  bool failed_ = false;
  double entered_ = 0.0;  ///< when the present step began [s]
  double sent_ = 0.0;     ///< when the last command to the node was sent [s]
};

}  // namespace fourwis::can
