#pragma once

#include <cstdint>
#include <optional>

#include "fault_reporter.h"
#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/can/protocol/cia301.h"
#include "steady.h"

namespace fourwis::can
{

/// Supervises one drive that has been started: its heartbeat, one answer to each SYNC, measurements that are possible,
/// and that it follows its target.
class AxisWatch
{
public:
  /// `max_speed` of the axis [counts/s]. An error beyond `error` [rad or m/s] is the fault `not_followed`.
  AxisWatch(const BridgeOptions& options, double max_speed, double error, Fault not_followed, FaultReporter report);

  void begin(double now);

  void receive_heartbeat(NmtState state, double now);
  void receive_status(double now);
  void receive_motion(std::int32_t position, double now);
  void sync_sent();

  /// The position may jump, because the drive searches its zero.
  void expect_jump() { position_.reset(); }

  /// Once a cycle.
  void supervise(double now);
  /// Once a cycle for a drive in operation, with the difference of its target and its measurement.
  void supervise_following(double difference, double now);
  void not_following() { off_.reset(); }

private:
  void count_answer(int& unanswered, double now);

  double max_speed_, error_;
  double heartbeat_timeout_, cycle_time_;
  int lost_after_;    ///< the drive is lost after this many SYNCs without an answer
  int most_unasked_;  ///< allowed number of answers in excess of SYNCs
  Fault not_followed_;
  FaultReporter report_;
  Steady off_;
  double heard_ = 0.0;  ///< time of its last heartbeat [s]
  int unanswered_status_ = 0, unanswered_motion_ = 0;
  int unasked_ = 0;  ///< answers in excess of SYNCs
  bool rebooted_ = false;
  std::optional<std::int32_t> position_;  ///< [counts]
  double moved_ = 0.0;                    ///< when `position_` was received [s]
};

}  // namespace fourwis::can
