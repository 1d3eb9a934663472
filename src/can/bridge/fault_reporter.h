#pragma once

#include "fourwis_navigation/can/bridge/faults.h"

namespace fourwis::can
{

/// Reports the faults of one axis.
class FaultReporter
{
public:
  /// `log` must outlive this.
  FaultReporter(FaultLog& log, int axis) : log_(&log), axis_(axis) {}

  void operator()(Fault fault, std::uint32_t detail, double now, std::uint32_t object = 0) const
  {
    log_->report(fault, axis_, detail, now, object);
  }

private:
  FaultLog* log_;
  int axis_;
};

}  // namespace fourwis::can
