#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "fourwis_navigation/can/protocol/frame.h"

namespace fourwis::can
{

/// The result of an attempt to send or receive. Once a bus is open nothing throws: a bus that breaks is an expected
/// failure.
enum class BusStatus
{
  ok,
  would_block,  ///< nothing to receive, or no room to send
  down,         ///< the interface is or was down or gone; stays so until recover(), so that each gap is noticed
  failed        ///< this frame cannot be sent, or another error of the operating system; see last_error()
};

struct BusCounters
{
  std::uint64_t sent = 0;
  std::uint64_t received = 0;
  std::uint64_t refused = 0;  ///< frames that found no room
  std::uint64_t dropped = 0;  ///< frames of others that were lost, because this end reads too slowly
  std::uint64_t invalid = 0;  ///< received data that is not a frame
};

/// One end of a CAN bus. A frame that is sent reaches all other ends, in order, and does not come back to the sender.
/// An end that does not read loses frames and does not delay the others. Sending and receiving neither block nor
/// allocate. To be used by one thread at a time.
class Bus
{
public:
  virtual ~Bus() = default;

  virtual BusStatus send(const Frame& frame) = 0;
  virtual BusStatus receive(Frame& frame) = 0;

  /// A file descriptor that becomes readable when there is something to receive or the state has changed. -1 if there
  /// is none to wait for: the bus is down, or within one thread. recover() may change it.
  virtual int descriptor() const = 0;

  /// After `down`: opens the interface anew if it exists, and discards what was not read. Returns whether frames can be
  /// sent.
  virtual bool recover() = 0;

  virtual BusCounters counters() const = 0;
  virtual std::string_view last_error() const = 0;  ///< in words, valid until the next call; empty if there is none
};

/// Opens an end of the bus called `name`. `unix:NAME` is a bus among the processes of this machine that needs no CAN in
/// the kernel; any other name is that of a SocketCAN interface. A bus that does not exist yet is opened in the state
/// `down`. Throws std::invalid_argument for a name that is not valid.
std::unique_ptr<Bus> open_bus(const std::string& name);

}  // namespace fourwis::can
