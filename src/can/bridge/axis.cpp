#include "axis.h"

#include <cmath>

namespace fourwis::can
{
namespace
{

/// Time that a drive may take to leave its fault [s].
constexpr double kResetTime = 1.0;

bool is_steering(int index)
{
  return index < kWheels;
}

const AxisOptions& options_of(const BridgeOptions& options, int index)
{
  const auto wheel = static_cast<std::size_t>(index % kWheels);
  return is_steering(index) ? options.steering[wheel] : options.driving[wheel];
}

AxisWatch watch_of(const Robot& robot, const BridgeOptions& options, const AxisScale& scale, bool steering,
                   FaultReporter report)
{
  const double counts = std::abs(scale.counts_per_unit());
  if (steering) return {options, counts * robot.wheel_max_rate, options.steering_error, Fault::steering_stuck, report};
  return {options, counts * robot.wheel_max_speed, options.speed_error, Fault::speed_not_followed, report};
}

bool is_in_fault(DriveState state)
{
  return state == DriveState::fault || state == DriveState::fault_reaction;
}

}  // namespace

Axis::Axis(const Robot& robot, const BridgeOptions& options, int index, FaultLog& log)
  : steering_(is_steering(index)),
    node_(options_of(options, index).node),
    scale_(scale_of(options, options_of(options, index), steering_)),
    mode_(working_mode(options, steering_)),
    report_fault_(log, index),
    startup_(robot, options, options_of(options, index), steering_, report_fault_),
    watch_(watch_of(robot, options, scale_, steering_, report_fault_)),
    homing_(steering_ && options.homing, options.homing_timeout, report_fault_),
    telemetry_(options, node_),
    late_(options.enable_timeout)
{}

void Axis::restart(bool reset_fault, double now, Outbox& outbox)
{
  has_status_ = has_motion_ = false;
  resetting_ = reset_fault;
  was_in_operation_ = false;
  goal_ = PowerGoal::off;
  homing_.begin();
  startup_.begin(now, outbox);
}

void Axis::receive(Service service, const Frame& frame, double now, Outbox& outbox)
{
  if (service == Service::sdo_reply)
    return startup_.done() ? telemetry_.receive(frame) : startup_.receive_sdo(frame, now, outbox);
  const auto heartbeat = decode_heartbeat(frame);
  const auto status = decode_drive_status(frame);
  const auto motion = decode_drive_motion(frame);
  const auto emergency = decode_emergency(frame);
  if (heartbeat) return receive_heartbeat(*heartbeat, now, outbox);
  if (status) return receive_status(*status, now);
  if (motion) return receive_motion(*motion, now);
  if (emergency) return receive_emergency(*emergency, now);
  const bool ours = service == Service::heartbeat || service == Service::emergency || service == Service::tpdo1 ||
                    service == Service::tpdo2;
  // Before a drive is set up, its cyclic messages may have any content.
  if (ours && startup_.is_set_up()) report_fault_(Fault::malformed_frame, frame.id, now);
}

void Axis::supervise(double now, Outbox& outbox)
{
  startup_.supervise(now, outbox);
  if (!startup_.done()) return;
  watch_.supervise(now);
  supervise_power(now);
  telemetry_.supervise(now, outbox);
}

void Axis::sync_sent(double now)
{
  synced_ = now;
  if (startup_.done()) watch_.sync_sent();
}

void Axis::command(PowerGoal goal, double target, double now, Outbox& outbox)
{
  if (!startup_.is_set_up()) return;
  goal_ = goal;
  target_ = target;
  if (goal != PowerGoal::on)
  {
    was_in_operation_ = false;
    homing_.interrupt();
  }
  DriveCommand command;
  command.controlword = word(goal, now);
  command.mode = homing_.done() ? mode_ : OperationMode::homing;
  command.target = follows() ? counts_of(target) : resting_counts();
  outbox.put(encode_drive_command(node_, command));
}

void Axis::stop(Outbox& outbox) const
{
  outbox.put(encode_drive_command(node_, {control::quick_stop, mode_, 0}));
}

StartStep Axis::step() const
{
  if (!startup_.done()) return startup_.step();
  const DriveState power = state();
  if (resetting_ || power == DriveState::not_ready || power == DriveState::unknown) return StartStep::starting;
  return homing_.running() ? StartStep::homing : StartStep::started;
}

bool Axis::in_operation() const
{
  return startup_.done() && state() == DriveState::operation_enabled && homing_.done() &&
         status_.mode == static_cast<std::int8_t>(mode_);
}

bool Axis::out_of_operation() const
{
  const DriveState power = state();
  return !startup_.done() || (power != DriveState::operation_enabled && power != DriveState::quick_stop_active &&
                              power != DriveState::fault_reaction);
}

AxisReport Axis::report() const
{
  const DriveState power = has_status_ ? state() : DriveState::unknown;
  return {nmt_,       power,   status_.statusword,   emergency_,
          position(), speed(), telemetry_.voltage(), telemetry_.temperature()};
}

void Axis::receive_heartbeat(NmtState state, double now, Outbox& outbox)
{
  nmt_ = state;
  if (startup_.done())
    watch_.receive_heartbeat(state, now);
  else
    startup_.receive_heartbeat(state, now, outbox);
}

void Axis::receive_status(const DriveStatus& status, double now)
{
  if (!startup_.is_set_up()) return;
  status_ = status;
  has_status_ = true;
  if (startup_.done())
    watch_.receive_status(now);
  else
    finish_start(now);
}

void Axis::receive_motion(const DriveMotion& motion, double now)
{
  if (!startup_.is_set_up()) return;
  if (measured_at_ > 0.0) rolled_ += scale_.to_rate(counts_between(motion_.position, motion.position));
  motion_ = motion;
  has_motion_ = true;
  measured_at_ = synced_;
  if (!homing_.done()) watch_.expect_jump();
  if (startup_.done())
    watch_.receive_motion(motion.position, now);
  else
    finish_start(now);
}

void Axis::receive_emergency(const Emergency& emergency, double now)
{
  emergency_ = emergency.code;
  if (emergency.code != 0 && startup_.done()) report_fault_(Fault::emergency_message, emergency.code, now);
}

void Axis::finish_start(double now)
{
  if (!has_status_ || !has_motion_) return;
  startup_.receive_cyclic();
  if (!startup_.done()) return;
  watch_.begin(now);
  telemetry_.begin(now);
  late_.reset();
  resetting_ = resetting_ && is_in_fault(state());
  reset_until_ = now + kResetTime;
}

void Axis::supervise_power(double now)
{
  const DriveState power = state();
  resetting_ = resetting_ && is_in_fault(power) && now < reset_until_;
  if (is_in_fault(power) && !resetting_) report_fault_(Fault::drive_fault, status_.statusword, now);
  if (late_.update(step() == StartStep::starting, now)) report_fault_(Fault::power_timeout, status_.statusword, now);
  homing_.supervise(status_, now);

  if (goal_ == PowerGoal::on && was_in_operation_ && power != DriveState::operation_enabled)
    report_fault_(Fault::drive_disabled, status_.statusword, now);
  was_in_operation_ |= in_operation() && goal_ == PowerGoal::on;

  if (!was_in_operation_) return watch_.not_following();
  watch_.supervise_following(target_ - (steering_ ? position() : speed()), now);
}

bool Axis::follows() const
{
  return in_operation() && (goal_ == PowerGoal::on || goal_ == PowerGoal::keep);
}

std::uint16_t Axis::word(PowerGoal goal, double now)
{
  if (resetting_)
  {
    reset_edge_ = !reset_edge_;
    return reset_edge_ ? control::fault_reset : control::disable_voltage;
  }
  const std::uint16_t word = controlword(state(), goal);
  if (word != control::enable_operation || state() != DriveState::operation_enabled) return word;
  if (!homing_.done()) return word | homing_.bits(status_, now);
  return mode_ == OperationMode::profile_position && follows() ? word | set_point_bits(status_.statusword) : word;
}

std::int32_t Axis::counts_of(double target) const
{
  return steering_ ? scale_.to_counts(target) : scale_.to_rate_counts(target);
}

/// The target of a drive that does not follow yet: its present position, or speed 0. An old target would move the motor
/// as soon as the drive begins to follow.
std::int32_t Axis::resting_counts() const
{
  return steering_ ? motion_.position : 0;
}

}  // namespace fourwis::can
