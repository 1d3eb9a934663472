#pragma once

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <system_error>

#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "fourwis_navigation/can/bus/file_descriptor.h"

namespace fourwis::can
{

/// Wakes another thread that waits for the descriptor. raise() does not wait.
class SignalEvent
{
public:
  SignalEvent() : event_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK))
  {
    if (event_.get() < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
  }

  void raise()
  {
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = write(event_.get(), &one, sizeof one);
  }

  /// Whether it has been raised since the last clear() or wait().
  bool clear()
  {
    std::uint64_t count = 0;
    return read(event_.get(), &count, sizeof count) > 0;
  }

  /// Waits until it is raised, at most `timeout` [s]; whether it was.
  bool wait(double timeout)
  {
    pollfd item{event_.get(), POLLIN, 0};
    poll(&item, 1, std::max(0, static_cast<int>(timeout * 1e3)));
    return clear();
  }

  int descriptor() const { return event_.get(); }

private:
  FileDescriptor event_;
};

}  // namespace fourwis::can
