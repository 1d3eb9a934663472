#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <string>

namespace fourwis::can
{

/// Everything that can go wrong with a base, by name; doc/can_bridge.md says what each means and how to clear it.
enum class Fault : std::uint8_t
{
  // The bus.
  link_down,
  bus_off,
  transmit_timeout,
  error_passive,
  receive_overflow,
  foreign_master,
  // One drive, from its start on.
  duplicate_node,
  boot_timeout,
  wrong_device,
  mode_unsupported,
  sdo_timeout,
  sdo_abort,
  setting_not_kept,
  start_timeout,
  homing_failed,
  // One drive, at work.
  heartbeat_lost,
  node_rebooted,
  node_not_operational,
  emergency_message,
  drive_fault,
  drive_disabled,
  feedback_lost,
  malformed_frame,
  encoder_jump,
  steering_stuck,
  speed_not_followed,
  // The base.
  power_timeout,
  alignment_timeout,
  // The commands.
  command_timeout,
  invalid_command,
  unsupported_motion,
  emergency_stop,
  count
};

/// What a fault does to a base.
enum class Reaction : std::uint8_t
{
  note,     ///< is reported, nothing else
  stop,     ///< stops at once; ~enable starts it again
  restart,  ///< stops at once and starts the drives anew by itself; then as `stop`
  latch     ///< stops at once; needs ~clear_faults, then ~enable
};

const char* to_string(Fault fault);
Reaction reaction(Fault fault);

/// The axes of a base: four steering, then four driving, in wheel order.
inline constexpr int kAxes = 8;
inline constexpr int kNoAxis = -1;

/// "steering front_left"; "base" for kNoAxis.
const char* axis_name(int axis);

struct FaultRecord
{
  Fault fault = Fault::count;
  int axis = kNoAxis;
  std::uint32_t detail = 0;  ///< depends on the fault: error code, statusword or identifier
  std::uint32_t object = 0;  ///< the object of the drive that is concerned, index << 8 | sub-index; 0: none
  double time = 0.0;         ///< when it was detected [s]

  bool exists() const { return fault != Fault::count; }
};

/// "driving rear_left: emergency_message 0x8130", "steering front_left: sdo_abort 0x6040041 (the object cannot be
/// mapped) at 1600:01"; empty for a record that does not exist.
std::string text_of(const FaultRecord& record);

/// The faults since the last clear(). A fault of an axis is recorded once, even if it is reported many times. Faults
/// with the reaction `restart` are recorded each time. No allocation.
class FaultLog
{
public:
  static constexpr std::size_t kKept = 32;

  void report(Fault fault, int axis, std::uint32_t detail, double now, std::uint32_t object = 0);

  /// The strongest reaction that was reported since the last call.
  Reaction take_reaction();

  /// The first fault with the strongest reaction: why the base stands.
  const FaultRecord& cause() const { return cause_; }
  /// The newest faults, newest first, also those from before the last clear().
  const std::array<FaultRecord, kKept>& history() const { return history_; }

  void clear();

private:
  static constexpr std::size_t kFaults = static_cast<std::size_t>(Fault::count);

  std::array<std::bitset<kFaults>, kAxes + 1> reported_;
  std::array<FaultRecord, kKept> history_;
  FaultRecord cause_;
  Reaction pending_ = Reaction::note;
};

}  // namespace fourwis::can
