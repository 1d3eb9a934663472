#pragma once

#include <array>
#include <vector>

#include "axis.h"

namespace fourwis::can
{

/// A base with eight CiA 402 drives, four that steer and four that drive. The bridge is their SYNC producer and master.
class Cia402Base final : public BaseProtocol
{
public:
  /// `log` must outlive this.
  Cia402Base(const Robot& robot, const BridgeOptions& options, FaultLog& log);

  void restart(bool reset_faults, double now, Outbox& outbox) override;
  void receive(const Frame& frame, double now, Outbox& outbox) override;
  void supervise(double now, Outbox& outbox) override;
  void command(const DriveDemand& demand, double now, Outbox& outbox) override;
  void end_cycle(double now, Outbox& outbox) override;

  StartStep step() const override;
  int first_able_to_move() const override;
  int first_not_following() const override;
  const WheelMotion& measured() const override { return measured_; }
  double measured_at() const override;
  const char* refusal(const WheelCommand&) const override { return nullptr; }
  AxisReport axis(int axis) const override { return axes_[static_cast<std::size_t>(axis)].report(); }

private:
  static constexpr int kNodes = 128;

  void stop(Outbox& outbox) const;
  int first_axis(bool (*is_it)(const Axis&)) const;
  bool is_masters(const Address& address) const;
  void measure();

  int master_;
  double heartbeat_period_, listen_time_;
  FaultReporter report_;
  std::vector<Axis> axes_;
  std::array<int, kNodes> axis_of_node_;
  bool listening_ = true;
  bool foreign_ = false;     ///< another master commands these drives; seen while listening, nothing is sent
  bool ran_before_ = false;  ///< the drives have been set up by this bridge before
  bool reset_faults_ = false;
  double listen_until_ = 0.0;
  double heartbeat_sent_;  ///< when the last heartbeat was sent [s]
  WheelMotion measured_;
};

}  // namespace fourwis::can
