#pragma once

#include <cstdint>
#include <optional>

#include "fault_reporter.h"
#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/can/protocol/cia301.h"
#include "steady.h"

namespace fourwis::can
{

/// Looks after one drive that has been started: does it live, does it answer each SYNC, once and not twice, are its
/// measurements possible, does it do what it is told?
class AxisWatch
{
public:
  /// `max_speed` of the axis [counts/s]; `error` beyond which it does not follow [rad or m/s], of `not_followed`.
  AxisWatch(const BridgeOptions& options, double max_speed, double error, Fault not_followed, FaultReporter report);

  void begin(double now);

  void receive_heartbeat(NmtState state, double now);
  void receive_status(double now);
  void receive_motion(std::int32_t position, double now);
  void sync_sent();

  /// What is measured may jump: the drive looks for its zero.
  void expect_jump() { position_.reset(); }

  /// Once a cycle.
  void supervise(double now);
  /// Once a cycle for a drive in operation; the difference of what it is told and what it does.
  void supervise_following(double difference, double now);
  void not_following() { off_.reset(); }

private:
  void count_answer(int& unanswered, double now);

  double max_speed_, error_;
  double heartbeat_timeout_, cycle_time_;
  int lost_after_;    ///< so many SYNCs without an answer
  int most_unasked_;  ///< answers in excess of SYNCs that may come
  Fault not_followed_;
  FaultReporter report_;
  Steady off_;
  double heard_ = 0.0;  ///< its last heartbeat
  int unanswered_status_ = 0, unanswered_motion_ = 0;
  int unasked_ = 0;  ///< answers in excess of SYNCs
  bool rebooted_ = false;
  std::optional<std::int32_t> position_;  ///< [counts]
  double moved_ = 0.0;                    ///< when `position_` was received
};

}  // namespace fourwis::can
