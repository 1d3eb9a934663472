#include "fourwis_navigation/can/bus/real_time.h"

#include <cerrno>
#include <cstring>

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <time.h>

namespace fourwis::can
{

double monotonic_now()
{
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::string become_real_time(int priority)
{
  std::string complaint;
  sched_param parameters{};
  parameters.sched_priority = priority;
  if (const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters))
    complaint += std::string("no real-time priority (") + std::strerror(error) +
                 "): allow it by a line 'USER - rtprio 99' in /etc/security/limits.conf. ";
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
    complaint += std::string("memory is not locked (") + std::strerror(errno) +
                 "): allow it by a line 'USER - memlock unlimited' there. ";
  return complaint;
}

}  // namespace fourwis::can
