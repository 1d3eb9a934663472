#pragma once

#include <string>

namespace fourwis::can
{

/// The time of a clock that is never set, since an arbitrary beginning [s].
double monotonic_now();

/// The highest priority that Linux has; the lowest is 1.
constexpr int kHighestPriority = 99;

/// Gives the calling thread precedence over all ordinary ones (SCHED_FIFO of that priority, 1 to kHighestPriority) and prevents
/// that the memory of the process is paged out. Returns in words what the system did not allow and how to allow it; empty
/// if it allowed all.
std::string become_real_time(int priority);

}  // namespace fourwis::can
