#pragma once

#include <string>

namespace fourwis::can
{

/// The time that no clock setting moves, since some beginning [s].
double monotonic_now();

/// Makes the calling thread preempt all ordinary ones (SCHED_FIFO of that priority, 1 to 99) and keeps the process's
/// memory from being paged out. What the system does not allow, and how to allow it, in words; empty when it allows
/// all.
std::string become_real_time(int priority);

}  // namespace fourwis::can
