#include "axis_startup.h"

namespace fourwis::can
{
namespace
{

/// Period of the resets of a node that has not booted, and of the start commands to one that has not started [s].
constexpr double kResetPeriod = 1.0, kStartPeriod = 0.1;
/// Time that a node may take from its start to its cyclic messages [s].
constexpr double kStartTimeout = 1.0;
/// Two boot-up messages within this time come from two nodes with the same id [s].
constexpr double kShortestReboot = 0.01;

}  // namespace

AxisStartup::AxisStartup(const Robot& robot, const BridgeOptions& options, const AxisOptions& axis, bool steering,
                         FaultReporter report)
  : node_(axis.node),
    boot_timeout_(options.boot_timeout),
    identification_(identification_script(options, steering)),
    configuration_(configuration_script(robot, options, axis, steering)),
    client_(axis.node, options.sdo_timeout),
    report_(report)
{}

void AxisStartup::begin(double now, Outbox& outbox)
{
  failed_ = false;
  client_.stop();
  enter(StartStep::booting, now);
  send(NmtCommand::reset_communication, now, outbox);
}

void AxisStartup::receive_heartbeat(NmtState state, double now, Outbox& outbox)
{
  if (failed_ || state != NmtState::boot_up || step_ == StartStep::listening) return;
  if (step_ != StartStep::booting && now - entered_ < kShortestReboot)
    return fail(Fault::duplicate_node, static_cast<std::uint32_t>(node_), now);
  enter(StartStep::identifying, now);
  client_.start(identification_, now, outbox);
}

void AxisStartup::receive_sdo(const Frame& frame, double now, Outbox& outbox)
{
  if (failed_) return;
  client_.receive(frame, now, outbox);
  go_on(now, outbox);
}

void AxisStartup::receive_cyclic()
{
  if (step_ == StartStep::starting && !failed_) step_ = StartStep::started;
}

void AxisStartup::supervise(double now, Outbox& outbox)
{
  if (failed_) return;
  client_.supervise(now, outbox);
  go_on(now, outbox);
  if (step_ == StartStep::booting)
  {
    if (now - entered_ > boot_timeout_) return fail(Fault::boot_timeout, 0, now);
    if (now - sent_ > kResetPeriod) send(NmtCommand::reset_communication, now, outbox);
  }
  if (step_ == StartStep::starting)
  {
    if (now - entered_ > kStartTimeout) return fail(Fault::start_timeout, 0, now);
    if (now - sent_ > kStartPeriod) send(NmtCommand::start, now, outbox);
  }
}

void AxisStartup::go_on(double now, Outbox& outbox)
{
  if (client_.state() == SdoClient::State::failed)
    return fail(client_.fault(), client_.detail(), now, client_.object());
  if (client_.state() != SdoClient::State::done) return;
  if (step_ == StartStep::identifying)
  {
    enter(StartStep::configuring, now);
    client_.start(configuration_, now, outbox);
  }
  else if (step_ == StartStep::configuring)
  {
    client_.stop();
    enter(StartStep::starting, now);
    send(NmtCommand::start, now, outbox);
  }
}

void AxisStartup::send(NmtCommand command, double now, Outbox& outbox)
{
  sent_ = now;
  outbox.add(encode_nmt(command, node_));
}

void AxisStartup::fail(Fault fault, std::uint32_t detail, double now, std::uint32_t object)
{
  failed_ = true;
  client_.stop();
  report_(fault, detail, now, object);
}

}  // namespace fourwis::can
