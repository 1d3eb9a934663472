#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fourwis_navigation/can/protocol/frame.h"

/// CANopen, CiA 301: who sends what, and the messages that are not about drives. Pure bytes. A decoder answers
/// nothing for a frame that is not its message or has the wrong length; node numbers are 1 to 127.
namespace fourwis::can
{

/// The kind of message that an identifier stands for; the number is the function code, its upper four bits.
enum class Service : std::uint8_t
{
  nmt = 0,
  sync = 1,       ///< 080 itself
  emergency = 2,  ///< 080 + node; shares the function code of `sync`, so not its own
  tpdo1 = 3,      ///< from the drive
  rpdo1 = 4,      ///< to the drive
  tpdo2 = 5,
  rpdo2 = 6,
  tpdo3 = 7,
  rpdo3 = 8,
  tpdo4 = 9,
  rpdo4 = 10,
  sdo_reply = 11,    ///< from the drive
  sdo_request = 12,  ///< to the drive
  heartbeat = 14,
  other = 15  ///< nothing of CiA 301 that we know
};

/// What an identifier says. `node` is 0 where the message is for or from all.
struct Address
{
  Service service = Service::other;
  int node = 0;
};

Address address_of(const Frame& frame);

/// The identifier of a message; not for `other`.
std::uint32_t cob_id(Service service, int node);

/// Commands to the state of a node itself.
enum class NmtCommand : std::uint8_t
{
  start = 1,
  stop = 2,
  enter_pre_operational = 128,
  reset_node = 129,
  reset_communication = 130
};

/// The state of a node itself, as its heartbeat has it.
enum class NmtState : std::uint8_t
{
  boot_up = 0,
  stopped = 4,
  operational = 5,
  pre_operational = 127
};

const char* to_string(NmtState state);

/// `node` 0 means all.
Frame encode_nmt(NmtCommand command, int node);
Frame encode_sync();
Frame encode_heartbeat(int node, NmtState state);

/// Nothing also for a state that is none.
std::optional<NmtState> decode_heartbeat(const Frame& frame);

/// A drive says that something is wrong, or with code 0 that nothing is any more.
struct Emergency
{
  std::uint16_t code = 0;
  std::uint8_t error_register = 0;  ///< object 1001
  std::array<std::uint8_t, 5> vendor{};
};

std::optional<Emergency> decode_emergency(const Frame& frame);

}  // namespace fourwis::can
