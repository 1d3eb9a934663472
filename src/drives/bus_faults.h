#pragma once

#include "fault_schedule.h"
#include "frames.h"

namespace fourwis::drives
{

/// Other nodes on the bus that disturb the drives: another master, a second node of the same id, a node that floods the
/// bus, controllers that report errors. Times in s.
class BusFaults
{
public:
  /// `bit_rate` [bit/s] of the bus, which a flood fills.
  BusFaults(const FaultSchedule& faults, double bit_rate) : faults_(faults), bit_rate_(bit_rate) {}

  /// Sends their frames of a step of `dt` that ends at `now`.
  void step(double now, double dt, const FrameSink& send);

private:
  void flood(const DriveFault& fault, double dt, const FrameSink& send);

  const FaultSchedule& faults_;
  double bit_rate_;
  double cycle_ = 0.0;      ///< when the last cycle at 100 Hz began
  double bits_left_ = 0.0;  ///< bits of time on the bus that the flood has not filled yet
};

}  // namespace fourwis::drives
