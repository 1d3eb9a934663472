#pragma once

#include <cstdint>

#include <ros/time.h>

namespace fourwis
{

/// Time from one stamp to another [s], the double that is nearest to it: 0.02 where the stamps are 20 ms apart. Of any two
/// stamps, while a ros::Duration does not hold the difference of two wild ones, which throws.
inline double seconds_between(const ros::Time& from, const ros::Time& to)
{
  return static_cast<double>(static_cast<std::int64_t>(to.toNSec() - from.toNSec())) / 1e9;
}

/// A step back of the clock by more than this is its owner's will, a shorter one a reading that came late [s].
constexpr double kClockSetBack = 0.5;

/// The stamp of what was measured after `last`: `stamp`, but right after `last` where that is a little earlier, as when the
/// thread was held up between its readings of two clocks.
inline ros::Time in_order(const ros::Time& last, const ros::Time& stamp)
{
  const double back = seconds_between(stamp, last);
  return back >= 0.0 && back <= kClockSetBack ? last + ros::Duration(0, 1) : stamp;
}

}  // namespace fourwis
