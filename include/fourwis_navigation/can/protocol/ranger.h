#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "fourwis_navigation/can/protocol/frame.h"
#include "fourwis_navigation/model/wheels.h"

/// AgileX Ranger, CAN protocol v2, after ugv_sdk: 11-bit identifiers, big-endian, two's complement. Pure bytes. A
/// decoder returns nothing for a frame that is another message or has not 8 bytes.
namespace fourwis::can
{

/// The mode of the base: message 141, feedback 291.
enum class RangerMode : std::uint8_t
{
  dual_ackermann = 0,
  parallel = 1,
  spin = 2,
  park = 3,
  side_slip = 4
};

/// Messages 111 and 221. Saturated to 16 bits of thousandths.
struct RangerMotion
{
  double speed = 0.0;     ///< forward [m/s]
  double yaw = 0.0;       ///< [rad/s]
  double lateral = 0.0;   ///< to the left [m/s]
  double steering = 0.0;  ///< in dual-Ackermann mode of the inner wheel [rad]
};

Frame encode_ranger_motion(const RangerMotion& motion);
Frame encode_ranger_mode(RangerMode mode);
Frame encode_ranger_can_control();  ///< the base is to obey the bus instead of its remote control
Frame encode_ranger_clear_errors();

/// Message 211, ten times a second.
struct RangerState
{
  std::uint8_t vehicle = 0;  ///< 0 normal, 1 emergency stop, 2 failure
  std::uint8_t control = 0;  ///< 0 standby, 1 CAN, 2 serial, 3 remote control
  double voltage = 0.0;      ///< of the battery [V]
  std::uint16_t errors = 0;  ///< bits
};
std::optional<RangerState> decode_ranger_state(const Frame& frame);
std::optional<RangerMotion> decode_ranger_motion(const Frame& frame);

/// Messages 271 and 281: angles [rad] and speeds [m/s] of the four wheels in the order of the base.
std::optional<PerWheel> decode_ranger_angles(const Frame& frame);
std::optional<PerWheel> decode_ranger_speeds(const Frame& frame);

/// Message 291.
struct RangerModeState
{
  std::uint8_t mode = 0;  ///< a number of RangerMode
  bool changing = false;
};
std::optional<RangerModeState> decode_ranger_mode(const Frame& frame);

}  // namespace fourwis::can
