#pragma once

#include <cmath>

#include <ros/time.h>

#include "stamps.h"

namespace fourwis
{

/// A stamp that another node gave, or `now` where it is zero or farther than `tolerance` [s] from it. What is done at the
/// stamp of a message, not when it happens to arrive, is done again when the message is replayed.
inline ros::Time plausible(const ros::Time& stamp, const ros::Time& now, double tolerance)
{
  return std::abs(seconds_between(now, stamp)) <= tolerance ? stamp : now;
}

}  // namespace fourwis
