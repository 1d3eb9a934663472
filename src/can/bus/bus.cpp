#include "fourwis_navigation/can/bus/bus.h"

#include <net/if.h>

#include <stdexcept>

#include "socketcan_bus.h"
#include "unix_bus.h"

namespace fourwis::can
{
namespace
{

const std::string kUnixPrefix = "unix:";
constexpr std::size_t kLongestUnixName = 32;

const std::string kAllowed =
    "expected unix:NAME (1 to 32 letters, digits, '_', '-', '.'), a bus among the processes of this machine, or a "
    "SocketCAN interface such as can0 or vcan0 (at most 15 of them)";

/// Letters, digits, `_`, `-`, and `.` except as the first character.
bool is_plain(const std::string& name)
{
  const std::string letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  return !name.empty() && name.front() != '.' && name.find_first_not_of(letters) == std::string::npos;
}

}  // namespace

std::unique_ptr<Bus> open_bus(const std::string& name)
{
  const bool is_unix = name.compare(0, kUnixPrefix.size(), kUnixPrefix) == 0;
  const std::string rest = is_unix ? name.substr(kUnixPrefix.size()) : name;
  if (!is_plain(rest) || rest.size() > (is_unix ? kLongestUnixName : IFNAMSIZ - 1))
    throw std::invalid_argument("bus '" + name + "': " + kAllowed);
  if (is_unix) return std::make_unique<UnixBus>(rest);
  return std::make_unique<SocketCanBus>(rest);
}

}  // namespace fourwis::can
