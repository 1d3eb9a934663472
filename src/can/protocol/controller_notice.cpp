#include "fourwis_navigation/can/protocol/controller_notice.h"

namespace fourwis::can
{
namespace
{

/// Bits of the identifier.
constexpr std::uint32_t kTransmitTimeout = 0x001, kController = 0x004, kNoAcknowledge = 0x020, kBusOff = 0x040,
                        kRestarted = 0x100;
/// Bits of data[1] with kController.
constexpr std::uint8_t kReceiveOverflow = 0x01, kTransmitOverflow = 0x02, kWarning = 0x0C, kPassive = 0x30,
                       kActive = 0x40;

}  // namespace

bool tells_state(const ControllerNotice& notice)
{
  return notice.bus_off || notice.restarted || notice.warning || notice.passive || notice.active;
}

std::optional<ControllerNotice> decode_notice(const Frame& frame)
{
  if (!frame.error) return std::nullopt;
  const std::uint8_t state = frame.id & kController && frame.size > 1 ? frame.data[1] : 0;
  ControllerNotice notice;
  notice.bus_off = frame.id & kBusOff;
  notice.restarted = frame.id & kRestarted;
  notice.transmit_timeout = frame.id & kTransmitTimeout;
  notice.no_acknowledge = frame.id & kNoAcknowledge;
  notice.receive_overflow = state & kReceiveOverflow;
  notice.transmit_overflow = state & kTransmitOverflow;
  notice.warning = state & kWarning;
  notice.passive = state & kPassive;
  notice.active = state & kActive;
  if (frame.size == 8)
  {
    notice.transmit_errors = frame.data[6];
    notice.receive_errors = frame.data[7];
  }
  return notice;
}

}  // namespace fourwis::can
