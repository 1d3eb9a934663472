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

}  // namespace fourwis
