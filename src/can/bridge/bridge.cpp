#include "fourwis_navigation/can/bridge/bridge.h"

#include "bridge_state.h"
#include "fourwis_navigation/can/protocol/frame_bits.h"
#include "link_watch.h"
#include "load_meter.h"
#include "make_protocol.h"
#include "motion.h"
#include "stop_procedure.h"

namespace fourwis::can
{

class Bridge::Implementation
{
public:
  Implementation(const Robot& robot, const BridgeOptions& options)
    : options_(options),
      protocol_(make_protocol(robot, options, log_)),
      link_(options, log_),
      motion_(robot, options),
      stop_(options),
      load_(options.bit_rate)
  {}

  void set_link(bool up, double now)
  {
    link_.set_up(up, now);
    react(now);
  }

  void receive(const Frame& frame, double now)
  {
    link_.receive(frame, now);
    if (!frame.error) load_.add(worst_case_bits(frame));
    if (!frame.error && is_communicating()) protocol_->receive(frame, now, outbox_);
    react(now);
  }

  void command(const WheelCommand& command, double made, double now)
  {
    if (state_ != BridgeState::enabled) return;
    if (take(command, made, now) && !sent_between_cycles_)
    {
      sent_between_cycles_ = true;
      motion_.follow(protocol_->measured(), now);
      transmit(now);
    }
    react(now);
  }

  void press_emergency_stop(bool pressed, double now)
  {
    pressed_ = pressed;
    if (pressed) log_.report(Fault::emergency_stop, kNoAxis, 0, now);
    react(now);
  }

  const char* enable(double now)
  {
    if (state_ == BridgeState::enabled) return nullptr;
    if (state_ == BridgeState::enabling) return "already being enabled";
    if (state_ == BridgeState::fault) return "in fault: clear the faults first";
    if (state_ == BridgeState::stopping) return "still stopping";
    if (state_ != BridgeState::ready) return "the drives are not ready yet";
    if (pressed_) return "the emergency stop is pressed";
    log_.clear();
    motion_.begin(now);
    enter(BridgeState::enabling, now);
    return nullptr;
  }

  const char* disable(double now)
  {
    if (state_ == BridgeState::enabled) stop(StopProcedure::Kind::ramp, BridgeState::stopping, now);
    if (state_ == BridgeState::enabling) stop(StopProcedure::Kind::brake, BridgeState::stopping, now);
    return nullptr;
  }

  const char* clear_faults(double now)
  {
    if (state_ == BridgeState::fault && stop_.phase() == StopProcedure::Phase::braking) return "still stopping";
    log_.clear();
    if (state_ != BridgeState::fault) return nullptr;
    reset_faults_ = true;
    wait_for_link(now);
    return nullptr;
  }

  void cycle(double now)
  {
    sent_between_cycles_ = false;
    link_.supervise(outbox_, now);
    if (is_communicating()) protocol_->supervise(now, outbox_);
    supervise_commands(now);
    react(now);
    advance(now);
    move(now);
    publish();
    transmit(now);
    end_cycle(now);
  }

  Outbox& outbox() { return outbox_; }
  const WheelState& wheels() const { return wheels_; }

  BridgeReport report() const
  {
    BridgeReport report;
    report.stage = bridge_stage(state_, protocol_->step());
    report.cause = log_.cause();
    report.history = log_.history();
    report.emergency_stop = pressed_;
    report.out_of_operation = protocol_->out_of_operation();
    report.load = load_.load();
    report.replaced = outbox_.replaced();
    report.overtaken = overtaken_;
    report.controller = link_.notice();
    for (int i = 0; i < kAxes; ++i) report.axes[static_cast<std::size_t>(i)] = protocol_->axis(i);
    return report;
  }

private:
  /// Frames of drives that have not been started anew since the bus was lost have no meaning.
  bool is_communicating() const { return link_.usable() && state_ != BridgeState::waiting; }

  bool may_move() const
  {
    return state_ == BridgeState::enabling || state_ == BridgeState::enabled || state_ == BridgeState::stopping;
  }

  void enter(BridgeState state, double now)
  {
    state_ = state;
    entered_ = now;
  }

  void stop(StopProcedure::Kind kind, BridgeState state, double now)
  {
    stop_.begin(kind, now);
    motion_.reset();
    enter(state, now);
  }

  void wait_for_link(double now)
  {
    stop_.cancel();
    motion_.reset();
    outbox_.clear();
    enter(BridgeState::waiting, now);
  }

  /// Whether the command is to be followed.
  bool take(const WheelCommand& command, double made, double now)
  {
    const CommandWatch::Verdict verdict = motion_.take(command, made, now);
    if (verdict == CommandWatch::Verdict::overtaken) ++overtaken_;
    if (verdict == CommandWatch::Verdict::invalid) log_.report(Fault::invalid_command, kNoAxis, 0, now);
    if (verdict != CommandWatch::Verdict::taken) return false;
    if (protocol_->refusal(command) == nullptr) return true;
    log_.report(Fault::unsupported_motion, kNoAxis, static_cast<std::uint32_t>(command.mode), now);
    return false;
  }

  void supervise_commands(double now)
  {
    if (state_ != BridgeState::enabled) return;
    if (motion_.is_command_expired(now)) log_.report(Fault::command_timeout, kNoAxis, 0, now);
    if (motion_.alignment_overdue()) log_.report(Fault::alignment_timeout, kNoAxis, 0, now);
  }

  /// Carries out the reaction to the faults that were reported since the last call, and sends its frames at once.
  void react(double now)
  {
    const Reaction reaction = log_.take_reaction();
    if (reaction == Reaction::note || (reaction == Reaction::stop && !may_move())) return;
    motion_.halt(now);
    if (state_ == BridgeState::fault) return;
    if (reaction == Reaction::stop) stop(StopProcedure::Kind::brake, BridgeState::stopping, now);
    if (reaction == Reaction::restart) wait_for_link(now);
    if (reaction == Reaction::latch) stop(StopProcedure::Kind::brake, BridgeState::fault, now);
    transmit(now);
  }

  void advance(double now)
  {
    switch (state_)
    {
      case BridgeState::waiting: return start(now);
      case BridgeState::starting:
        if (protocol_->step() == StartStep::started) enter(BridgeState::ready, now);
        return;
      case BridgeState::enabling: return finish_enabling(now);
      case BridgeState::stopping:
      case BridgeState::fault: return go_on_stopping(now);
      case BridgeState::ready:
      case BridgeState::enabled: return;
    }
  }

  void start(double now)
  {
    if (!link_.usable()) return;
    protocol_->restart(reset_faults_, now, outbox_);
    reset_faults_ = false;
    enter(BridgeState::starting, now);
  }

  void finish_enabling(double now)
  {
    if (protocol_->in_operation()) return enter(BridgeState::enabled, now);
    // Homing has a timeout of its own.
    if (protocol_->step() == StartStep::homing) entered_ = now;
    if (now - entered_ > options_.enable_timeout)
      log_.report(Fault::power_timeout, protocol_->first_not_following(), 0, now);
  }

  void go_on_stopping(double now)
  {
    stop_.update(greatest_magnitude(protocol_->measured().speed), greatest_magnitude(motion_.setpoint().speed),
                 protocol_->out_of_operation(), now);
    if (state_ == BridgeState::fault) return;
    if (now - entered_ > options_.stop_timeout + options_.enable_timeout)
      log_.report(Fault::power_timeout, protocol_->first_able_to_move(), 0, now);
    if (stop_.phase() != StopProcedure::Phase::done) return;
    stop_.cancel();
    enter(BridgeState::ready, now);
  }

  void move(double now)
  {
    const bool stopping = state_ == BridgeState::stopping || state_ == BridgeState::fault;
    if (state_ == BridgeState::enabled)
      motion_.follow(protocol_->measured(), now);
    else if (!stopping)
      motion_.hold(protocol_->measured(), now);
    else if (stop_.kind() == StopProcedure::Kind::ramp)
      motion_.ramp_down(now);
    else
      motion_.halt(now);
  }

  void publish()
  {
    wheels_.stamp = protocol_->measured_at();
    wheels_.state = base_state(state_);
    wheels_.mode = motion_.newest().mode;
    wheels_.sequence = motion_.newest().sequence;
    wheels_.motion = protocol_->measured();
    wheels_.aligned = state_ == BridgeState::enabled && motion_.aligned();
  }

  DriveDemand demand() const
  {
    DriveDemand demand;
    demand.mode = motion_.mode();
    demand.motion = motion_.setpoint();
    const bool on = state_ == BridgeState::enabling || state_ == BridgeState::enabled;
    if (on) demand.steering = demand.driving = PowerGoal::on;
    if (stop_.phase() == StopProcedure::Phase::braking)
    {
      demand.steering = PowerGoal::keep;
      demand.driving = stop_.kind() == StopProcedure::Kind::ramp ? PowerGoal::keep : PowerGoal::quick_stop;
    }
    return demand;
  }

  void transmit(double now)
  {
    if (is_communicating()) protocol_->command(demand(), now, outbox_);
  }

  void end_cycle(double now)
  {
    load_.add(outbox_.sent_bits() - counted_bits_);
    counted_bits_ = outbox_.sent_bits();
    load_.update(now);
    if (is_communicating())
      protocol_->end_cycle(now, outbox_);
    else
      outbox_.clear();
  }

  const BridgeOptions options_;
  FaultLog log_;
  Outbox outbox_;
  std::unique_ptr<BaseProtocol> protocol_;
  LinkWatch link_;
  Motion motion_;
  StopProcedure stop_;
  LoadMeter load_;
  BridgeState state_ = BridgeState::waiting;
  double entered_ = 0.0;  ///< when the present state began [s]
  bool pressed_ = false;
  /// Whether the next start resets faults. The first does: drives in delivery state go into fault when their
  /// communication is reset.
  bool reset_faults_ = true;
  bool sent_between_cycles_ = false;  ///< a command was sent since the last cycle
  std::uint64_t overtaken_ = 0;
  double counted_bits_ = 0.0;
  WheelState wheels_;
};

Bridge::Bridge(const Robot& robot, const BridgeOptions& options)
{
  check(robot, options);
  implementation_ = std::make_unique<Implementation>(robot, options);
}
Bridge::~Bridge() = default;

void Bridge::set_link(bool up, double now)
{
  implementation_->set_link(up, now);
}
void Bridge::receive(const Frame& frame, double now)
{
  implementation_->receive(frame, now);
}
void Bridge::command(const WheelCommand& command, double made, double now)
{
  implementation_->command(command, made, now);
}
void Bridge::press_emergency_stop(bool pressed, double now)
{
  implementation_->press_emergency_stop(pressed, now);
}
const char* Bridge::enable(double now)
{
  return implementation_->enable(now);
}
const char* Bridge::disable(double now)
{
  return implementation_->disable(now);
}
const char* Bridge::clear_faults(double now)
{
  return implementation_->clear_faults(now);
}
void Bridge::cycle(double now)
{
  implementation_->cycle(now);
}
Outbox& Bridge::outbox()
{
  return implementation_->outbox();
}
const WheelState& Bridge::wheels() const
{
  return implementation_->wheels();
}
BridgeReport Bridge::report() const
{
  return implementation_->report();
}

}  // namespace fourwis::can
