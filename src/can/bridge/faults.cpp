#include "fourwis_navigation/can/bridge/faults.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <utility>

#include "fourwis_navigation/can/protocol/sdo.h"

namespace fourwis::can
{

const char* to_string(Fault fault)
{
  switch (fault)
  {
    case Fault::link_down: return "link_down";
    case Fault::bus_off: return "bus_off";
    case Fault::transmit_timeout: return "transmit_timeout";
    case Fault::error_passive: return "error_passive";
    case Fault::receive_overflow: return "receive_overflow";
    case Fault::foreign_master: return "foreign_master";
    case Fault::duplicate_node: return "duplicate_node";
    case Fault::boot_timeout: return "boot_timeout";
    case Fault::wrong_device: return "wrong_device";
    case Fault::mode_unsupported: return "mode_unsupported";
    case Fault::sdo_timeout: return "sdo_timeout";
    case Fault::sdo_abort: return "sdo_abort";
    case Fault::setting_not_kept: return "setting_not_kept";
    case Fault::start_timeout: return "start_timeout";
    case Fault::homing_failed: return "homing_failed";
    case Fault::heartbeat_lost: return "heartbeat_lost";
    case Fault::node_rebooted: return "node_rebooted";
    case Fault::node_not_operational: return "node_not_operational";
    case Fault::emergency_message: return "emergency_message";
    case Fault::drive_fault: return "drive_fault";
    case Fault::drive_disabled: return "drive_disabled";
    case Fault::feedback_lost: return "feedback_lost";
    case Fault::malformed_frame: return "malformed_frame";
    case Fault::encoder_jump: return "encoder_jump";
    case Fault::steering_stuck: return "steering_stuck";
    case Fault::speed_not_followed: return "speed_not_followed";
    case Fault::power_timeout: return "power_timeout";
    case Fault::alignment_timeout: return "alignment_timeout";
    case Fault::command_timeout: return "command_timeout";
    case Fault::invalid_command: return "invalid_command";
    case Fault::unsupported_motion: return "unsupported_motion";
    case Fault::emergency_stop: return "emergency_stop";
    case Fault::count: break;
  }
  return "none";
}

Reaction reaction(Fault fault)
{
  switch (fault)
  {
    case Fault::error_passive:
    case Fault::receive_overflow: return Reaction::note;
    case Fault::command_timeout:
    case Fault::invalid_command:
    case Fault::unsupported_motion:
    case Fault::emergency_stop: return Reaction::stop;
    case Fault::link_down:
    case Fault::bus_off: return Reaction::restart;
    default: return Reaction::latch;
  }
}

const char* axis_name(int axis)
{
  static const char* const names[kAxes] = {"steering front_left", "steering front_right", "steering rear_left",
                                           "steering rear_right", "driving front_left",   "driving front_right",
                                           "driving rear_left",   "driving rear_right"};
  return axis >= 0 && axis < kAxes ? names[axis] : "base";
}

std::string text_of(const FaultRecord& record)
{
  if (!record.exists()) return "";
  std::ostringstream text;
  text << axis_name(record.axis) << ": " << to_string(record.fault);
  text << std::hex << std::setfill('0');
  if (record.detail != 0) text << " 0x" << record.detail;
  if (record.fault == Fault::sdo_abort) text << " (" << sdo_abort_text(record.detail) << ')';
  if (record.object != 0)
    text << " at " << std::setw(4) << (record.object >> 8) << ':' << std::setw(2) << (record.object & 0xFF);
  return text.str();
}

void FaultLog::report(Fault fault, int axis, std::uint32_t detail, double now, std::uint32_t object)
{
  const int row = axis + 1;  // the first is that of the whole base
  auto reported = reported_.at(static_cast<std::size_t>(row))[static_cast<std::size_t>(fault)];
  if (reported && reaction(fault) != Reaction::restart) return;
  reported = true;

  const FaultRecord record{fault, axis, detail, object, now};
  std::move_backward(history_.begin(), history_.end() - 1, history_.end());
  history_.front() = record;
  if (!cause_.exists() || reaction(fault) > reaction(cause_.fault)) cause_ = record;
  pending_ = std::max(pending_, reaction(fault));
}

Reaction FaultLog::take_reaction()
{
  return std::exchange(pending_, Reaction::note);
}

void FaultLog::clear()
{
  for (auto& reported : reported_) reported.reset();
  cause_ = {};
  pending_ = Reaction::note;
}

}  // namespace fourwis::can
