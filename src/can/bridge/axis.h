#pragma once

#include <cstdint>

#include "axis_homing.h"
#include "axis_startup.h"
#include "axis_telemetry.h"
#include "axis_watch.h"

namespace fourwis::can
{

/// One CiA 402 drive: its start, its power stage, what it measures and what is wrong with it.
class Axis
{
public:
  /// `index` as in axis_name(); `log` must outlive this.
  Axis(const Robot& robot, const BridgeOptions& options, int index, FaultLog& log);

  void restart(bool reset_fault, double now, Outbox& outbox);
  /// A frame of its node.
  void receive(Service service, const Frame& frame, double now, Outbox& outbox);
  void supervise(double now, Outbox& outbox);
  void sync_sent(double now);

  /// Brings the power stage nearer to `goal`; in operation the drive follows `target` [rad or m/s].
  void command(PowerGoal goal, double target, double now, Outbox& outbox);
  /// Quick stop and speed 0 with the next SYNC, in any state. For a driving axis whose state is not known.
  void stop(Outbox& outbox) const;

  int node() const { return node_; }
  StartStep step() const;
  bool in_operation() const;
  bool out_of_operation() const;
  double position() const { return steering_ ? scale_.to_position(motion_.position) : rolled_; }  ///< [rad or m]
  double speed() const { return scale_.to_rate(motion_.velocity); }                               ///< [rad/s or m/s]
  double measured_at() const { return measured_at_; }  ///< the SYNC with which both were measured; 0: never [s]
  AxisReport report() const;

private:
  void receive_heartbeat(NmtState state, double now, Outbox& outbox);
  void receive_status(const DriveStatus& status, double now);
  void receive_motion(const DriveMotion& motion, double now);
  void receive_emergency(const Emergency& emergency, double now);
  void finish_start(double now);
  void supervise_power(double now);
  DriveState state() const { return drive_state(status_.statusword); }
  bool follows() const;
  std::uint16_t word(PowerGoal goal, double now);
  std::int32_t counts_of(double target) const;
  std::int32_t resting_counts() const;

  bool steering_;
  int node_;
  AxisScale scale_;
  OperationMode mode_;
  FaultReporter report_fault_;
  AxisStartup startup_;
  AxisWatch watch_;
  AxisHoming homing_;
  AxisTelemetry telemetry_;
  Steady late_;  ///< the drive has been started but cannot be switched on
  NmtState nmt_ = NmtState::boot_up;
  DriveStatus status_;
  DriveMotion motion_;
  double rolled_ = 0.0;       ///< driving: since the first measurement [m]
  double synced_ = 0.0;       ///< when the last SYNC was sent [s]
  double measured_at_ = 0.0;  ///< [s]
  std::uint16_t emergency_ = 0;
  bool has_status_ = false, has_motion_ = false;  ///< since the start
  bool resetting_ = false;                        ///< a fault is to be reset before the axis counts as started
  double reset_until_ = 0.0;
  bool reset_edge_ = false;
  PowerGoal goal_ = PowerGoal::off;
  double target_ = 0.0;
  bool was_in_operation_ = false;  ///< since the goal became `on`
};

}  // namespace fourwis::can
