#include "ranger_base.h"

#include <algorithm>
#include <limits>

namespace fourwis::can
{
namespace
{

/// Time of listening before anything is sent, and the period of the requests for control after that [s].
constexpr double kListenTime = 0.1, kAskPeriod = 0.1;
/// The base reports its state every 100 ms and its wheels every 20 ms. It is lost after these times without a report
/// [s].
constexpr double kStateTimeout = 0.35, kWheelsTimeout = 0.1;
/// Least time between two commands. Stops are sent at once. The base wants commands every 20 ms [s].
constexpr double kCommandPeriod = 0.015;
/// The base stands when all wheels are slower than this [m/s].
constexpr double kStands = 0.01;
constexpr double kNever = -std::numeric_limits<double>::infinity();
/// The number of the vehicle's state `failure`, and the identifiers of commands, which only another master would send.
constexpr std::uint8_t kFailure = 2;
constexpr std::uint32_t kCommandIds[] = {0x111, 0x141, 0x421};
constexpr std::uint32_t kFeedbackIds[] = {0x211, 0x221, 0x271, 0x281, 0x291};

template <class Ids>
bool contains(const Ids& ids, const Frame& frame)
{
  return !frame.extended && !frame.remote && std::find(std::begin(ids), std::end(ids), frame.id) != std::end(ids);
}

bool moves(const RangerMotion& motion)
{
  return motion.speed != 0.0 || motion.yaw != 0.0 || motion.lateral != 0.0;
}

/// Speed 0 with the angle held.
RangerMotion standing(double steering)
{
  RangerMotion motion;
  motion.steering = steering;
  return motion;
}

}  // namespace

RangerBase::RangerBase(const Robot& robot, const BridgeOptions& options, FaultLog& log)
  : kinematics_(robot, options.ranger),
    boot_timeout_(options.boot_timeout),
    steering_error_(options.steering_error),
    speed_error_(options.speed_error),
    report_(log, kNoAxis),
    state_at_(kNever),
    mode_at_(kNever),
    angles_at_(kNever),
    speeds_at_(kNever),
    told_at_(kNever),
    stuck_(options.following_time),
    off_speed_(options.following_time)
{}

void RangerBase::restart(bool reset_faults, double now, Outbox& outbox)
{
  // The base may still roll.
  if (told_) outbox.put(encode_ranger_motion(standing(told_->steering)));
  told_.reset();
  reset_faults_ = reset_faults;
  step_ = StartStep::listening;
  entered_ = now;
  state_at_ = mode_at_ = angles_at_ = speeds_at_ = kNever;
  follows_ = foreign_ = false;
  stuck_.reset();
  off_speed_.reset();
}

void RangerBase::receive(const Frame& frame, double now, Outbox&)
{
  if (contains(kCommandIds, frame))
  {
    foreign_ = true;
    report_(Fault::foreign_master, frame.id, now);
  }
  if (!take(frame, now) && contains(kFeedbackIds, frame)) report_(Fault::malformed_frame, frame.id, now);
}

/// Whether the frame is a message of the protocol.
bool RangerBase::take(const Frame& frame, double now)
{
  if (const auto state = decode_ranger_state(frame)) return state_ = *state, state_at_ = now, true;
  if (const auto mode = decode_ranger_mode(frame)) return mode_ = *mode, mode_at_ = now, true;
  if (const auto angles = decode_ranger_angles(frame)) return angles_ = *angles, angles_at_ = now, true;
  if (!decode_ranger_speeds(frame)) return decode_ranger_motion(frame).has_value();
  speeds_ = *decode_ranger_speeds(frame);
  speeds_at_ = measured_at_ = now;
  measured_ = kinematics_.measured(angles_, speeds_, wanted_.angle);
  return true;
}

void RangerBase::supervise(double now, Outbox& outbox)
{
  if (step_ == StartStep::started)
    supervise_base(now);
  else
    supervise_start(now, outbox);
}

void RangerBase::supervise_start(double now, Outbox& outbox)
{
  if (foreign_ || now - entered_ < kListenTime) return;
  if (now - entered_ > boot_timeout_) return report_(Fault::boot_timeout, 0, now);
  step_ = state_at_ == kNever ? StartStep::booting : StartStep::starting;
  if (now - asked_ > kAskPeriod)
  {
    asked_ = now;
    outbox.put(encode_ranger_can_control());
    if (reset_faults_) outbox.put(encode_ranger_clear_errors());
  }
  if (obeys() && std::min({state_at_, mode_at_, angles_at_, speeds_at_}) > entered_) step_ = StartStep::started;
}

void RangerBase::supervise_base(double now)
{
  if (now - state_at_ > kStateTimeout) report_(Fault::heartbeat_lost, 0, now);
  const bool lost = now - mode_at_ > kStateTimeout || now - std::min(angles_at_, speeds_at_) > kWheelsTimeout;
  if (lost) report_(Fault::feedback_lost, 0, now);
  if (state_.vehicle == kFailure) report_(Fault::drive_fault, state_.errors, now);
  if (follows_ && !obeys()) report_(Fault::drive_disabled, state_.control, now);
  supervise_following(now);
}

/// While the wheels stand, the timeout of the interlock applies instead.
void RangerBase::supervise_following(double now)
{
  const bool drives = follows_ && told_ && moves(*told_);
  const bool stuck = greatest_gap(measured_.angle, wanted_.angle) > steering_error_;
  const bool off_speed = greatest_gap(measured_.speed, wanted_.speed) > speed_error_;
  if (stuck_.update(drives && stuck, now)) report_(Fault::steering_stuck, 0, now);
  if (off_speed_.update(drives && off_speed, now)) report_(Fault::speed_not_followed, 0, now);
}

void RangerBase::command(const DriveDemand& demand, double now, Outbox& outbox)
{
  if (step_ != StartStep::started) return;
  follows_ = demand.driving == PowerGoal::on || (demand.driving == PowerGoal::keep && follows_);
  wanted_ = demand.motion;
  if (!is_to_be_told(demand)) return told_.reset();
  const RangerMotion motion = motion_of(demand);
  const bool is_stop = told_ && moves(*told_) && !moves(motion);
  if (now - told_at_ < kCommandPeriod && !is_stop) return;
  told_at_ = now;
  told_ = motion;
  outbox.put(encode_ranger_mode(kinematics_.base_mode(demand.mode)));
  outbox.put(encode_ranger_motion(motion));
}

/// Before the first command of an operation nothing is sent. After it, commands are sent until the base stands.
bool RangerBase::is_to_be_told(const DriveDemand& demand) const
{
  const bool stops = told_ && rolls();
  return demand.mode != Mode::none && (demand.driving != PowerGoal::off || stops);
}

/// Wheels that may roll keep their branch (angle + k pi). At rest they take the branch that the base can reach.
RangerMotion RangerBase::motion_of(const DriveDemand& demand) const
{
  const bool held = told_ && (!follows_ || moves(*told_) || rolls());
  const RangerMotion motion = kinematics_.base_motion(demand.mode, demand.motion, held ? told_->steering : 0.0);
  return follows_ && !is_turning(demand.mode) ? motion : standing(motion.steering);
}

bool RangerBase::is_turning(Mode mode) const
{
  return mode_.changing || mode_.mode != static_cast<std::uint8_t>(kinematics_.base_mode(mode));
}

bool RangerBase::rolls() const
{
  return greatest_magnitude(measured_.speed) > kStands;
}

AxisReport RangerBase::axis(int axis) const
{
  AxisReport report;
  report.node = state_at_ == kNever ? NmtState::boot_up : NmtState::operational;
  report.drive = state_.vehicle == kFailure ? DriveState::fault
                 : obeys() && follows_      ? DriveState::operation_enabled
                                            : DriveState::switched_on;
  report.statusword = state_.errors;
  if (state_at_ != kNever) report.voltage = state_.voltage;
  const auto wheel = static_cast<std::size_t>(axis % kWheels);
  (axis < kWheels ? report.position : report.speed) = axis < kWheels ? measured_.angle[wheel] : measured_.speed[wheel];
  return report;
}

}  // namespace fourwis::can
