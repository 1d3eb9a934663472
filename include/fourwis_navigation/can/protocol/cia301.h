#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fourwis_navigation/can/protocol/frame.h"

/// CANopen, CiA 301: the meaning of identifiers, and the messages that do not depend on a device profile. Pure bytes. A
/// decoder returns nothing for a frame that is another message or has the wrong length. Node numbers are 1 to 127.
namespace fourwis::can
{

/// The kind of message of an identifier. The number is the function code, the upper four bits of the identifier.
enum class Service : std::uint8_t
{
  nmt = 0,
  sync = 1,       ///< identifier 080
  emergency = 2,  ///< identifier 080 + node; its function code is that of `sync`
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
  other = 15  ///< any other identifier
};

/// The meaning of an identifier. `node` is 0 for messages to or from all nodes.
struct Address
{
  Service service = Service::other;
  int node = 0;
};

Address address_of(const Frame& frame);

/// The identifier of a message of any service but `other`.
std::uint32_t cob_id(Service service, int node);

/// Commands that change the state of a node.
enum class NmtCommand : std::uint8_t
{
  start = 1,
  stop = 2,
  enter_pre_operational = 128,
  reset_node = 129,
  reset_communication = 130
};

/// The state of a node, as in its heartbeat.
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

/// Nothing also for a number that is no state.
std::optional<NmtState> decode_heartbeat(const Frame& frame);

/// The message of a node about an error; code 0 means that there is no error any more.
struct Emergency
{
  std::uint16_t code = 0;
  std::uint8_t error_register = 0;  ///< object 1001
  std::array<std::uint8_t, 5> vendor{};
};

std::optional<Emergency> decode_emergency(const Frame& frame);

}  // namespace fourwis::can
