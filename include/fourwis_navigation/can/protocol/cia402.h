#pragma once

#include <cstdint>
#include <optional>

#include "fourwis_navigation/can/protocol/frame.h"

/// CANopen drives, CiA 402: the states of a drive, the words that change them, and the cyclic messages in our mapping.
/// Pure bytes and pure functions.
namespace fourwis::can
{

/// The states of a drive's power stage.
enum class DriveState : std::uint8_t
{
  not_ready,
  switch_on_disabled,
  ready_to_switch_on,
  switched_on,
  operation_enabled,
  quick_stop_active,
  fault_reaction,
  fault,
  unknown  ///< the statusword is that of no state
};

const char* to_string(DriveState state);

/// The state is given by statusword & 6F.
DriveState drive_state(std::uint16_t statusword);

/// Bits of the statusword.
namespace status_bit
{
inline constexpr std::uint16_t warning = 1 << 7, target_reached = 1 << 10, set_point_acknowledge = 1 << 12,
                               homing_attained = 1 << 12, homing_error = 1 << 13;
}

/// Words and bits of the controlword.
namespace control
{
inline constexpr std::uint16_t disable_voltage = 0x00, quick_stop = 0x02, shutdown = 0x06, switch_on = 0x07,
                               enable_operation = 0x0F, new_set_point = 1 << 4, homing_start = 1 << 4,
                               change_immediately = 1 << 5, fault_reset = 1 << 7;
}

/// The goal for the power stage of a drive.
enum class PowerGoal : std::uint8_t
{
  off,        ///< without torque
  keep,       ///< following its target if it already does, otherwise without torque
  on,         ///< following its target
  quick_stop  ///< braking with its quick-stop ramp, then without torque
};

/// The controlword that brings a drive one state nearer to its goal. Never resets a fault.
std::uint16_t controlword(DriveState state, PowerGoal goal);

/// The bits that make a drive in profile position mode take the newest target at once: a rising edge of
/// `new_set_point`, again whenever the drive has acknowledged the one before.
std::uint16_t set_point_bits(std::uint16_t statusword);

/// Object 6060.
enum class OperationMode : std::int8_t
{
  none = 0,
  profile_position = 1,
  profile_velocity = 3,
  homing = 6,
  cyclic_position = 8,
  cyclic_velocity = 9
};

/// Whether a mode is supported, by the value of object 6502.
bool supports(std::uint32_t supported_modes, OperationMode mode);

/// RPDO1: 6040, 6060, and 607A or 60FF.
struct DriveCommand
{
  std::uint16_t controlword = 0;
  OperationMode mode = OperationMode::none;
  std::int32_t target = 0;  ///< position [counts] or velocity [counts/s]
};
Frame encode_drive_command(int node, const DriveCommand& command);

/// TPDO1: 6041, 6061.
struct DriveStatus
{
  std::uint16_t statusword = 0;
  std::int8_t mode = 0;
};

/// TPDO2: 6064, 606C.
struct DriveMotion
{
  std::int32_t position = 0;  ///< [counts]
  std::int32_t velocity = 0;  ///< [counts/s]
};

// They return nothing for a frame of another message or another length.
std::optional<DriveStatus> decode_drive_status(const Frame& frame);
std::optional<DriveMotion> decode_drive_motion(const Frame& frame);

}  // namespace fourwis::can
