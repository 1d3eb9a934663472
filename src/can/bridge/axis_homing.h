#pragma once

#include <cstdint>

#include "fault_reporter.h"
#include "fourwis_navigation/can/bridge/bridge_options.h"
#include "fourwis_navigation/can/protocol/cia402.h"

namespace fourwis::can
{

/// Homing of one steering drive: once after each start it searches its zero, in its own homing mode (6).
class AxisHoming
{
public:
  AxisHoming(bool needed, double timeout, FaultReporter report) : needed_(needed), timeout_(timeout), report_(report) {}

  void begin() { done_ = !needed_, running_ = false; }

  /// The drive leaves operation. A homing that is not done starts again the next time.
  void interrupt() { running_ = false; }

  bool done() const { return done_; }
  bool running() const { return running_; }

  /// For a drive in operation in homing mode: the bits of its controlword.
  std::uint16_t bits(const DriveStatus& status, double now);

  /// Once a cycle, in any state of the drive: checks whether homing is done, has failed or takes too long.
  void supervise(const DriveStatus& status, double now);

private:
  bool needed_;
  double timeout_;
  FaultReporter report_;
  bool done_ = false, running_ = false;
  double begun_ = 0.0;
};

}  // namespace fourwis::can
