#pragma once

#include <cstdint>

#include "fourwis_navigation/can/bridge/bridge_options.h"

namespace fourwis::can
{

/// The nearest integer of 32 bits. Numbers beyond the range give the end of the range, NaN gives 0.
std::int32_t saturated_counts(double counts);

/// The difference of two positions whose 32 bits may have wrapped around in between.
std::int32_t counts_between(std::int32_t before, std::int32_t now);

/// Between a drive's counts and the wheel's units. Positions and speeds of a drive are counts and counts/s.
class AxisScale
{
public:
  /// A steering axis: its unit is the radian.
  static AxisScale steering(const AxisOptions& axis);
  /// A driving axis: its unit is the metre that the wheel rolls.
  static AxisScale driving(const AxisOptions& axis, double wheel_radius);

  /// Position [rad or m] <-> counts.
  std::int32_t to_counts(double position) const { return saturated_counts((position - offset_) * counts_per_unit_); }
  double to_position(std::int32_t counts) const { return counts / counts_per_unit_ + offset_; }

  /// Speed [rad/s or m/s] <-> counts/s; also for differences of position and for accelerations, which have no offset.
  std::int32_t to_rate_counts(double rate) const { return saturated_counts(rate * counts_per_unit_); }
  double to_rate(std::int32_t counts) const { return counts / counts_per_unit_; }

  double counts_per_unit() const { return counts_per_unit_; }  ///< negative where the axis is reversed

private:
  AxisScale(double counts_per_unit, double offset) : counts_per_unit_(counts_per_unit), offset_(offset) {}

  double counts_per_unit_;
  double offset_;
};

}  // namespace fourwis::can
