#include "socketcan_bus.h"

#include <linux/can/error.h>
#include <linux/can/raw.h>
#include <net/if.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include "wire_frame.h"

namespace fourwis::can
{
namespace
{

/// A frame takes about 700 bytes of it: enough for half a second of a full bus at 1 Mbit/s [bytes].
constexpr int kReceiveBuffer = 4 << 20;
/// The kernel raises it to its minimum, about 12 frames. With the default, hundreds of frames would wait in the queue.
constexpr int kSendBuffer = 0;

void set_option(int socket, int level, int option, int value)
{
  setsockopt(socket, level, option, &value, sizeof value);
}

/// These may fail: then frames are lost earlier or are not counted.
void set_options(int socket)
{
  set_option(socket, SOL_SOCKET, SO_SNDBUF, kSendBuffer);
  set_option(socket, SOL_SOCKET, SO_RCVBUF, kReceiveBuffer);       // up to net.core.rmem_max
  set_option(socket, SOL_SOCKET, SO_RCVBUFFORCE, kReceiveBuffer);  // beyond it, where this process may
  set_option(socket, SOL_SOCKET, SO_RXQ_OVFL, 1);
  set_option(socket, SOL_CAN_RAW, CAN_RAW_ERR_FILTER, CAN_ERR_MASK);
}

/// The number of the interface, 0 if there is none. To ask for it by name (ioctl, if_nametoindex) would make the kernel
/// start modprobe for a driver of that name each time it is missing.
int index_of(const std::string& interface)
{
  const std::unique_ptr<struct if_nameindex, decltype(&if_freenameindex)> all(if_nameindex(), if_freenameindex);
  const struct if_nameindex* one = all.get();
  while (one != nullptr && one->if_index != 0 && interface != one->if_name) ++one;
  return one != nullptr ? static_cast<int>(one->if_index) : 0;
}

/// 0 if the existing interface is up, otherwise errno.
int interface_error(int socket, const std::string& interface)
{
  ifreq request{};
  interface.copy(request.ifr_name, IFNAMSIZ - 1);
  if (ioctl(socket, SIOCGIFFLAGS, &request) != 0) return errno;
  return (request.ifr_flags & IFF_UP) != 0 ? 0 : ENETDOWN;
}

/// 0 if the socket is bound to the interface, otherwise errno. Binding to an interface that has just gone down
/// succeeds; its error is fetched afterwards.
int bind_error(int socket, int index)
{
  sockaddr_can address{};
  address.can_family = AF_CAN;
  address.can_ifindex = index;
  if (bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) return errno;
  int pending = 0;
  socklen_t size = sizeof pending;
  getsockopt(socket, SOL_SOCKET, SO_ERROR, &pending, &size);
  return pending;
}

std::string sentence(int error)
{
  if (error == EAFNOSUPPORT) return "the kernel has no CAN";
  if (error == ENODEV || error == ENXIO) return "there is no such interface";
  if (error == ENETDOWN) return "the link is down";
  return std::strerror(error);
}

/// The number of frames lost so far, if the message carries it, otherwise `before`.
std::uint32_t overflow_of(msghdr& message, std::uint32_t before)
{
  for (cmsghdr* note = CMSG_FIRSTHDR(&message); note != nullptr; note = CMSG_NXTHDR(&message, note))
    if (note->cmsg_level == SOL_SOCKET && note->cmsg_type == SO_RXQ_OVFL)
      std::memcpy(&before, CMSG_DATA(note), sizeof before);
  return before;
}

}  // namespace

SocketCanBus::SocketCanBus(std::string interface) : interface_(std::move(interface))
{
  open();
}

BusStatus SocketCanBus::send(const Frame& frame)
{
  if (!socket_) return BusStatus::down;
  if (!is_valid(frame))
  {
    error_ = kNoFrame;
    return BusStatus::failed;
  }
  const can_frame wire = to_wire(frame);
  if (write(socket_.get(), &wire, sizeof wire) != sizeof wire)
  {
    if (errno != EAGAIN && errno != ENOBUFS) return broken(errno);
    ++counters_.refused;
    return BusStatus::would_block;
  }
  error_.clear();
  ++counters_.sent;
  return BusStatus::ok;
}

BusStatus SocketCanBus::receive(Frame& frame)
{
  if (!socket_) return BusStatus::down;
  while (true)
  {
    can_frame wire;
    iovec part{&wire, sizeof wire};
    alignas(cmsghdr) char notes[CMSG_SPACE(sizeof overflowed_)];
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = notes;
    message.msg_controllen = sizeof notes;
    const ssize_t size = recvmsg(socket_.get(), &message, 0);
    if (size < 0) return errno == EAGAIN ? BusStatus::would_block : broken(errno);
    const std::uint32_t before = std::exchange(overflowed_, overflow_of(message, overflowed_));
    counters_.dropped += overflowed_ - before;
    if (size == sizeof wire && from_wire(wire, frame)) break;
    ++counters_.invalid;
  }
  ++counters_.received;
  return BusStatus::ok;
}

bool SocketCanBus::recover()
{
  if (!socket_) open();
  return static_cast<bool>(socket_);
}

void SocketCanBus::open()
{
  FileDescriptor socket(::socket(PF_CAN, SOCK_RAW | SOCK_NONBLOCK | SOCK_CLOEXEC, CAN_RAW));
  if (!socket) return go_down(errno);
  const int index = index_of(interface_);
  if (index == 0) return go_down(ENODEV);
  if (const int error = interface_error(socket.get(), interface_)) return go_down(error);
  set_options(socket.get());
  if (const int error = bind_error(socket.get(), index)) return go_down(error);
  socket_ = std::move(socket);
  overflowed_ = 0;
  error_.clear();
}

void SocketCanBus::go_down(int error)
{
  socket_.reset();
  error_ = interface_ + ": " + sentence(error);
}

/// To be called after sending or receiving has failed.
BusStatus SocketCanBus::broken(int error)
{
  if (error == ENETDOWN || error == ENODEV || error == ENXIO)
  {
    go_down(error);
    return BusStatus::down;
  }
  error_ = interface_ + ": " + sentence(error);
  return BusStatus::failed;
}

}  // namespace fourwis::can
