#pragma once

#include "fault_schedule.h"
#include "frames.h"

namespace fourwis::drives
{

/// Others on the bus who send what they should not: a foreign master, a second node of the same id, somebody who floods
/// it, controllers that complain. Times in s.
class Intruders
{
public:
  /// `bit_rate` [bit/s]: what a flood fills.
  Intruders(const FaultSchedule& faults, double bit_rate) : faults_(faults), bit_rate_(bit_rate) {}

  /// Sends what they send in a step of `dt` that ends at `now`.
  void step(double now, double dt, const FrameSink& send);

private:
  void flood(const DriveFault& fault, double dt, const FrameSink& send);

  const FaultSchedule& faults_;
  double bit_rate_;
  double cycle_ = 0.0;      ///< when those who send at 100 Hz have last sent
  double bits_left_ = 0.0;  ///< of what the bus has carried, not yet filled
};

}  // namespace fourwis::drives
