#include "axis_scale.h"

#include <cmath>
#include <limits>

namespace fourwis::can
{
namespace
{

/// Signed counts in a turn of the axis.
double counts_of_turn(const AxisOptions& axis)
{
  return axis.counts_per_turn * axis.gear_ratio * (axis.reversed ? -1.0 : 1.0);
}

}  // namespace

std::int32_t saturated_counts(double counts)
{
  using Limits = std::numeric_limits<std::int32_t>;
  if (std::isnan(counts)) return 0;
  if (counts >= Limits::max()) return Limits::max();
  if (counts <= Limits::min()) return Limits::min();
  return static_cast<std::int32_t>(std::lround(counts));
}

std::int32_t counts_between(std::int32_t before, std::int32_t now)
{
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(now) - static_cast<std::uint32_t>(before));
}

AxisScale AxisScale::steering(const AxisOptions& axis)
{
  return {counts_of_turn(axis) / (2.0 * M_PI), axis.offset};
}

AxisScale AxisScale::driving(const AxisOptions& axis, double wheel_radius)
{
  return {counts_of_turn(axis) / (2.0 * M_PI * wheel_radius), 0.0};
}

}  // namespace fourwis::can
