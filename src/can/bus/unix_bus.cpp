#include "unix_bus.h"

#include <sys/epoll.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <random>
#include <utility>

#include "wire_frame.h"

namespace fourwis::can
{
namespace
{

constexpr int kSocketType = SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC;
/// Greatest number of connections that wait to be accepted.
constexpr int kBacklog = 128;

/// The data that a connection carries for one frame.
struct Packet
{
  std::uint64_t number;
  can_frame frame;
};
static_assert(sizeof(Packet) == 24, "no padding");

/// A name that no other end has or had.
std::string unique_name()
{
  std::random_device random;
  char name[17];
  std::snprintf(name, sizeof name, "%08x%08x", random(), random());
  return name;
}

/// Calls bind or connect with the name of a file. Returns -1 with errno as they do.
template <typename Call>
int with_address(Call call, int socket, const std::string& file)
{
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (file.size() >= sizeof address.sun_path)
  {
    errno = ENAMETOOLONG;
    return -1;
  }
  std::copy(file.begin(), file.end(), address.sun_path);
  return call(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address);
}

}  // namespace

UnixBus::UnixBus(std::string name) : name_(std::move(name))
{
  open();
}

UnixBus::~UnixBus()
{
  go_down("");
}

BusStatus UnixBus::send(const Frame& frame)
{
  if (!is_down()) notice();
  if (is_down()) return BusStatus::down;
  if (!is_valid(frame))
  {
    error_ = kNoFrame;
    return BusStatus::failed;
  }
  error_.clear();
  to_.erase(std::remove_if(to_.begin(), to_.end(), [&](Connection& to) { return !hand_over(frame, to); }), to_.end());
  ++counters_.sent;
  return BusStatus::ok;
}

BusStatus UnixBus::receive(Frame& frame)
{
  epoll_event event;
  while (!is_down())
  {
    if (epoll_wait(events_.get(), &event, 1, 0) <= 0) return BusStatus::would_block;
    if (event.data.fd == directory_->descriptor())
      notice();
    else if (event.data.fd != listener_.get())
    {
      if (take(event.data.fd, frame)) return BusStatus::ok;
    }
    else if (!accept())
      return BusStatus::would_block;
  }
  return BusStatus::down;
}

bool UnixBus::recover()
{
  if (is_down()) open();
  return !is_down();
}

void UnixBus::open()
{
  directory_ = std::make_unique<BusDirectory>(name_);
  if (!directory_->error().empty()) return go_down(directory_->error());
  events_ = FileDescriptor(epoll_create1(EPOLL_CLOEXEC));
  if (!events_) return go_down(std::strerror(errno));
  watch(directory_->descriptor());
  listen();
  if (is_down()) return;
  error_.clear();
  connect_to_ends();
}

void UnixBus::go_down(const std::string& why)
{
  error_ = why;
  if (directory_ != nullptr && !own_file_.empty()) unlink(directory_->file(own_file_).c_str());
  own_file_.clear();
  to_.clear();
  from_.clear();
  listener_.reset();
  events_.reset();
  directory_.reset();
}

void UnixBus::watch(int descriptor)
{
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = descriptor;
  epoll_ctl(events_.get(), EPOLL_CTL_ADD, descriptor, &event);
}

/// The socket has a hidden name until it listens: other ends would remove one that refuses connections as a dead end.
void UnixBus::listen()
{
  own_file_ = unique_name();
  const std::string hidden = directory_->file('.' + own_file_), file = directory_->file(own_file_);
  listener_ = FileDescriptor(socket(AF_UNIX, kSocketType, 0));
  if (with_address(bind, listener_.get(), hidden) != 0 || ::listen(listener_.get(), kBacklog) != 0 ||
      rename(hidden.c_str(), file.c_str()) != 0)
    return go_down(file + ": " + std::strerror(errno));
  watch(listener_.get());
}

bool UnixBus::accept()
{
  FileDescriptor socket(accept4(listener_.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (!socket) return false;
  watch(socket.get());
  from_.push_back({std::move(socket), 0, ""});
  return true;
}

void UnixBus::notice()
{
  if (directory_->changed() || unconnected_) connect_to_ends();
}

/// Connects to new ends and drops those that have gone.
void UnixBus::connect_to_ends()
{
  unconnected_ = false;
  const auto ends = directory_->ends();
  if (!ends || ends->count(own_file_) == 0) return go_down(directory_->path() + " was taken away");
  const auto went = [&](const Connection& to) { return ends->count(to.file) == 0; };
  to_.erase(std::remove_if(to_.begin(), to_.end(), went), to_.end());
  for (const std::string& end : *ends)
  {
    const auto is_end = [&](const Connection& to) { return to.file == end; };
    if (end != own_file_ && std::none_of(to_.begin(), to_.end(), is_end)) connect(end);
  }
}

void UnixBus::connect(const std::string& file)
{
  FileDescriptor socket(::socket(AF_UNIX, kSocketType, 0));
  if (with_address(::connect, socket.get(), directory_->file(file)) == 0)
    to_.push_back({std::move(socket), 0, file});
  else if (errno == ECONNREFUSED)
    unlink(directory_->file(file).c_str());
  else
    unconnected_ |= errno != ENOENT;
}

/// False if the other end is gone.
bool UnixBus::hand_over(const Frame& frame, Connection& to)
{
  const Packet packet{to.next++, to_wire(frame)};
  if (::send(to.socket.get(), &packet, sizeof packet, MSG_NOSIGNAL) >= 0 || errno == EAGAIN || errno == ENOBUFS)
    return true;
  unlink(directory_->file(to.file).c_str());
  return false;
}

/// Receives from a connection; true if there was a frame.
bool UnixBus::take(int descriptor, Frame& frame)
{
  const auto from =
      std::find_if(from_.begin(), from_.end(), [&](const Connection& c) { return c.socket.get() == descriptor; });
  Packet packet;
  const ssize_t size = recv(descriptor, &packet, sizeof packet, MSG_TRUNC);
  if (size < 0 && errno == EAGAIN) return false;
  if (size <= 0)
  {
    from_.erase(from);
    return false;
  }
  if (size != sizeof packet || packet.number < from->next || !from_wire(packet.frame, frame))
  {
    ++counters_.invalid;
    return false;
  }
  counters_.dropped += packet.number - from->next;
  from->next = packet.number + 1;
  ++counters_.received;
  return true;
}

}  // namespace fourwis::can
