#include "ranger_base.h"

#include <algorithm>

namespace fourwis::can
{
namespace
{

/// Before we say anything we listen this long; then we ask for control this often [s].
constexpr double kListenTime = 0.1, kAskPeriod = 0.1;
/// The base reports its state every 100 ms and its wheels every 20 ms; without it for so long it is lost [s].
constexpr double kStateTimeout = 0.35, kWheelsTimeout = 0.1;
/// Commands are not sent more often, but for stops; the base wants them every 20 ms [s].
constexpr double kCommandPeriod = 0.015;
/// It stands when all wheels are slower [m/s].
constexpr double kStands = 0.01;
constexpr double kNever = -std::numeric_limits<double>::infinity();
/// Where the vehicle's state is a failure, and the identifiers of who else might command it.
constexpr std::uint8_t kFailure = 2;
constexpr std::uint32_t kCommandIds[] = {0x111, 0x141, 0x421};
constexpr std::uint32_t kFeedbackIds[] = {0x211, 0x221, 0x271, 0x281, 0x291};

template <class Ids>
bool contains(const Ids& ids, const Frame& frame)
{
  return !frame.extended && !frame.remote && std::find(std::begin(ids), std::end(ids), frame.id) != std::end(ids);
}

}  // namespace

RangerBase::RangerBase(const Robot& robot, const BridgeOptions& options, FaultLog& log)
  : kinematics_(robot, options.ranger), boot_timeout_(options.boot_timeout), report_(log, kNoAxis), state_at_(kNever),
    angles_at_(kNever), speeds_at_(kNever)
{
}

void RangerBase::restart(bool reset_faults, double now, Outbox&)
{
  reset_faults_ = reset_faults;
  stage_ = BaseStage::listening;
  entered_ = now;
  state_at_ = angles_at_ = speeds_at_ = kNever;
  follows_ = false;
}

void RangerBase::receive(const Frame& frame, double now, Outbox&)
{
  if (contains(kCommandIds, frame)) report_(Fault::foreign_master, frame.id, now);
  if (!take(frame, now) && contains(kFeedbackIds, frame)) report_(Fault::malformed_frame, frame.id, now);
}

/// Whether it is a message that we know.
bool RangerBase::take(const Frame& frame, double now)
{
  if (const auto state = decode_ranger_state(frame)) return state_ = *state, state_at_ = now, true;
  if (const auto mode = decode_ranger_mode(frame)) return mode_ = *mode, true;
  if (const auto angles = decode_ranger_angles(frame)) return angles_ = *angles, angles_at_ = now, true;
  if (!decode_ranger_speeds(frame)) return decode_ranger_motion(frame).has_value();
  speeds_ = *decode_ranger_speeds(frame);
  speeds_at_ = measured_at_ = now;
  measured_ = kinematics_.measured(angles_, speeds_, told_);
  return true;
}

void RangerBase::supervise(double now, Outbox& outbox)
{
  if (stage_ == BaseStage::started)
    supervise_base(now);
  else
    supervise_start(now, outbox);
}

void RangerBase::supervise_start(double now, Outbox& outbox)
{
  if (now - entered_ < kListenTime) return;
  if (now - entered_ > boot_timeout_) return report_(Fault::boot_timeout, 0, now);
  stage_ = state_at_ == kNever ? BaseStage::booting : BaseStage::starting;
  if (now - asked_ > kAskPeriod)
  {
    asked_ = now;
    outbox.put(encode_ranger_can_control());
    if (reset_faults_) outbox.put(encode_ranger_clear_errors());
  }
  if (obeys() && std::min({state_at_, angles_at_, speeds_at_}) > entered_) stage_ = BaseStage::started;
}

void RangerBase::supervise_base(double now)
{
  if (now - state_at_ > kStateTimeout) report_(Fault::heartbeat_lost, 0, now);
  if (now - std::min(angles_at_, speeds_at_) > kWheelsTimeout) report_(Fault::feedback_lost, 0, now);
  if (state_.vehicle == kFailure) report_(Fault::drive_fault, state_.errors, now);
  if (follows_ && !obeys()) report_(Fault::drive_disabled, state_.control, now);
}

void RangerBase::command(const DriveDemand& demand, double now, Outbox& outbox)
{
  if (stage_ != BaseStage::started) return;
  follows_ = demand.driving == PowerGoal::on || (demand.driving == PowerGoal::keep && follows_);
  told_ = demand.motion.angle;
  RangerMotion motion;
  if (follows_ && demand.mode != Mode::none) motion = kinematics_.base_motion(demand.mode, demand.motion);
  const bool turning = mode_.changing || mode_.mode != static_cast<std::uint8_t>(kinematics_.base_mode(demand.mode));
  if (turning) motion.speed = motion.yaw = motion.lateral = 0.0;
  const bool moves = motion.speed != 0.0 || motion.yaw != 0.0 || motion.lateral != 0.0;
  if (now - told_at_ < kCommandPeriod && (moves || !told_to_move_)) return;
  told_at_ = now;
  told_to_move_ = moves;
  if (demand.mode != Mode::none) outbox.put(encode_ranger_mode(kinematics_.base_mode(demand.mode)));
  outbox.put(encode_ranger_motion(motion));
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
  (axis < kWheels ? report.position : report.speed) =
    axis < kWheels ? measured_.angle[wheel] : measured_.speed[wheel];
  return report;
}

}  // namespace fourwis::can
