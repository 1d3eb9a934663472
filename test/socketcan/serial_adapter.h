#pragma once

#include <fcntl.h>
#include <linux/sockios.h>
#include <net/if.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

#include "command.h"

namespace fourwis::can
{

/// Simulates a serial CAN adapter (slcan), of which the kernel makes the interface scan0. Its controller has states,
/// which vcan does not have. It is removed at the end.
class SerialAdapter
{
public:
  SerialAdapter() : adapter_(posix_openpt(O_RDWR | O_NOCTTY))
  {
    grantpt(adapter_);
    unlockpt(adapter_);
    port_ = open(ptsname(adapter_), O_RDWR | O_NOCTTY);
    termios raw{};
    tcgetattr(port_, &raw);
    cfmakeraw(&raw);
    tcsetattr(port_, TCSANOW, &raw);
    const int slcan = 17;  // N_SLCAN of linux/tty.h
    EXPECT_EQ(ioctl(port_, TIOCSETD, &slcan), 0) << "no slcan in this kernel";
    ifreq interface {};
    EXPECT_EQ(ioctl(port_, SIOCGIFNAME, interface.ifr_name), 0);
    const std::string name = interface.ifr_name;
    // The kernel makes it in the first network namespace, which need not be this one.
    run("ip link show " + name + " >/dev/null 2>&1 || nsenter --net=/proc/1/ns/net ip link set " + name + " netns $$");
    run("ip link set " + name + " name scan0 && ip link set scan0 up");
  }
  ~SerialAdapter()
  {
    close(port_);
    close(adapter_);
  }
  SerialAdapter(const SerialAdapter&) = delete;
  SerialAdapter& operator=(const SerialAdapter&) = delete;

  /// "t1811CC": a frame of id 181 and one byte. "sb000248": off the bus, with these error counters.
  void say(const std::string& line)
  {
    const std::string text = line + '\r';
    EXPECT_EQ(write(adapter_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }

  /// The next frame that the kernel wants on the bus, as for say(); empty when there is none for a second.
  std::string hear()
  {
    while (true)
    {
      const std::size_t end = heard_.find('\r');
      if (end != std::string::npos)
      {
        const std::string line = heard_.substr(0, end);
        heard_.erase(0, end + 1);
        if (!line.empty() && line[0] == 't') return line;
        continue;
      }
      pollfd wait{adapter_, POLLIN, 0};
      if (poll(&wait, 1, 1000) <= 0) return "";
      char bytes[256];
      const ssize_t size = read(adapter_, bytes, sizeof bytes);
      if (size <= 0) return "";
      heard_.append(bytes, static_cast<std::size_t>(size));
    }
  }

private:
  int adapter_, port_ = -1;
  std::string heard_;
};

}  // namespace fourwis::can
