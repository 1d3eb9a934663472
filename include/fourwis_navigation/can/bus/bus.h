#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "fourwis_navigation/can/protocol/frame.h"

namespace fourwis::can
{

/// What became of an attempt to send or receive. Nothing throws once a bus is open: a bus that breaks is daily life.
enum class BusStatus
{
  ok,
  would_block,  ///< nothing to receive, or no room to send
  down,         ///< the interface is or was down or gone: nothing more until recover(), so that no gap goes unnoticed
  failed        ///< this frame cannot be sent, or the operating system says something else; see last_error()
};

struct BusCounters
{
  std::uint64_t sent = 0;
  std::uint64_t received = 0;
  std::uint64_t refused = 0;  ///< frames that found no room
  std::uint64_t dropped = 0;  ///< sent by others, but lost before they were read: this end reads too slowly
  std::uint64_t invalid = 0;  ///< what was received and is no frame
};

/// One end of a CAN bus: every frame sent reaches all other ends, in order, and none comes back to the sender. An end
/// that does not read loses frames and holds up nobody. Not blocking, no allocation when sending and receiving. One
/// thread at a time.
class Bus
{
public:
  virtual ~Bus() = default;

  virtual BusStatus send(const Frame& frame) = 0;
  virtual BusStatus receive(Frame& frame) = 0;

  /// Becomes readable when there is something to receive or to find out; -1 where there is none to wait for (down, or a
  /// bus within one thread). Another one after recover().
  virtual int descriptor() const = 0;

  /// Whether frames can be sent. After `down` opens the interface anew if it is there; what was not read is discarded.
  virtual bool recover() = 0;

  virtual BusCounters counters() const = 0;
  virtual std::string_view last_error() const = 0;  ///< for a person, until the next call; empty when all is well
};

/// Opens an end of the bus that `name` says: `unix:NAME` a bus among the processes of this machine that needs no CAN
/// in the kernel, anything else the SocketCAN interface of that name. A bus that is not there yet is opened in the
/// state `down`. Throws std::invalid_argument for a name that can be none.
std::unique_ptr<Bus> open_bus(const std::string& name);

}  // namespace fourwis::can
