#pragma once

#include <optional>

#include "fault_reporter.h"
#include "fourwis_navigation/can/bridge/base_protocol.h"
#include "ranger_motion.h"
#include "steady.h"

namespace fourwis::can
{

/// An AgileX Ranger: one controller that turns a mode, a speed and an angle into the motion of its wheels. It has no
/// drives that can be switched off. Out of operation it is commanded to stand, and when it stands, nothing is sent.
class RangerBase final : public BaseProtocol
{
public:
  /// `log` must outlive this.
  RangerBase(const Robot& robot, const BridgeOptions& options, FaultLog& log);

  void restart(bool reset_faults, double now, Outbox& outbox) override;
  void receive(const Frame& frame, double now, Outbox& outbox) override;
  void supervise(double now, Outbox& outbox) override;
  void command(const DriveDemand& demand, double now, Outbox& outbox) override;
  void end_cycle(double, Outbox&) override {}

  StartStep step() const override { return step_; }
  int first_able_to_move() const override { return follows_ || rolls() ? 0 : kNoAxis; }
  int first_not_following() const override { return follows_ && obeys() ? kNoAxis : 0; }
  const WheelMotion& measured() const override { return measured_; }
  double measured_at() const override { return measured_at_; }
  const char* refusal(const WheelCommand& command) const override { return kinematics_.refusal(command); }
  AxisReport axis(int axis) const override;

private:
  bool obeys() const { return state_.control == 1 && state_.vehicle == 0; }
  bool rolls() const;
  bool is_turning(Mode mode) const;
  bool take(const Frame& frame, double now);
  void supervise_start(double now, Outbox& outbox);
  void supervise_base(double now);
  void supervise_following(double now);
  bool is_to_be_told(const DriveDemand& demand) const;
  RangerMotion motion_of(const DriveDemand& demand) const;

  RangerKinematics kinematics_;
  double boot_timeout_, steering_error_, speed_error_;
  FaultReporter report_;
  StartStep step_ = StartStep::listening;
  bool reset_faults_ = false;
  bool foreign_ = false;  ///< another master commands the base; then it is not started
  bool follows_ = false;  ///< whether the base is to follow commands
  double entered_ = 0.0;  ///< when the present step began [s]
  double asked_ = 0.0;    ///< when control of the base was requested last [s]
  RangerState state_;
  RangerModeState mode_;
  PerWheel angles_{}, speeds_{};
  double state_at_, mode_at_, angles_at_, speeds_at_;  ///< when they were received [s]
  WheelMotion measured_;
  double measured_at_ = 0.0;
  WheelMotion wanted_;                ///< what the wheels should do
  std::optional<RangerMotion> told_;  ///< the last command that was sent in this operation
  double told_at_;
  Steady stuck_, off_speed_;
};

}  // namespace fourwis::can
