#include "bridge_diagnostics.h"

#include <cmath>

#include <ros/node_handle.h>

namespace fourwis
{

using can::BridgeReport;
using can::BridgeStage;
using can::BridgeUpdate;
using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

namespace
{

/// A fuller bus makes frames wait for more than a cycle.
constexpr double kFullBus = 0.8;

bool is_starting_or_driving(BridgeStage stage)
{
  return stage != BridgeStage::link_down && stage != BridgeStage::stopping && stage != BridgeStage::fault;
}

unsigned char level_of(const BridgeReport& report)
{
  if (report.stage == BridgeStage::fault || report.stage == BridgeStage::link_down) return DiagnosticStatus::ERROR;
  return report.cause.exists() || !is_starting_or_driving(report.stage) ? DiagnosticStatus::WARN : DiagnosticStatus::OK;
}

const char* controller_state(const can::ControllerNotice& notice)
{
  if (notice.bus_off) return "bus-off";
  if (notice.passive) return "error-passive";
  return notice.warning ? "error-warning" : "error-active";
}

unsigned char level_of(const can::AxisReport& axis)
{
  if (axis.drive == can::DriveState::fault || axis.drive == can::DriveState::fault_reaction)
    return DiagnosticStatus::ERROR;
  const bool warns = axis.emergency != 0 || (axis.statusword & can::status_bit::warning) != 0;
  return warns || axis.drive == can::DriveState::unknown ? DiagnosticStatus::WARN : DiagnosticStatus::OK;
}

}  // namespace

std::string explanation(const BridgeReport& report)
{
  const std::string cause = text_of(report.cause);
  if (report.stage == BridgeStage::enabled) return "";
  std::string text = report.stage == BridgeStage::ready ? "not enabled" : to_string(report.stage);
  if (report.emergency_stop) text += ", emergency stop pressed";
  return cause.empty() ? text : text + ": " + cause;
}

BridgeDiagnostics::BridgeDiagnostics(const BridgeMonitor& monitor, const std::string& interface) : monitor_(monitor)
{
  updater_.setHardwareID(interface);
  updater_.add("bridge", [this](DiagnosticStatusWrapper& status) { report_bridge(status); });
  updater_.add("bus", [this](DiagnosticStatusWrapper& status) { report_bus(status); });
  for (int axis = 0; axis < can::kAxes; ++axis)
    updater_.add(can::axis_name(axis), [this, axis](DiagnosticStatusWrapper& status) { report_axis(axis, status); });
  timer_ = ros::NodeHandle().createWallTimer(ros::WallDuration(0.1),
                                             [this](const ros::WallTimerEvent&) { updater_.update(); });
}

void BridgeDiagnostics::report_bridge(DiagnosticStatusWrapper& status) const
{
  const BridgeUpdate update = monitor_.newest();
  const std::string text = explanation(update.report);
  status.summary(level_of(update.report), text.empty() ? to_string(update.report.stage) : text);
  status.add("stage", to_string(update.report.stage));
  for (const can::FaultRecord& record : update.report.history)
    if (record.exists()) status.addf(text_of(record), "%.3f s ago", update.time - record.time);
  status.add("emergency stop", update.report.emergency_stop);
  status.add("overtaken commands", update.report.overtaken);
  status.add("late commands", late_commands_.load());
  status.addf("command to bus, 99 % [ms]", "%.3f", 1e3 * update.delays.percentile(0.99));
  status.addf("command to bus, longest [ms]", "%.3f", 1e3 * update.delays.longest());
  status.addf("latest cycle [ms]", "%.3f", 1e3 * update.latest_cycle);
  status.add("missed cycles", update.overruns);
}

void BridgeDiagnostics::report_bus(DiagnosticStatusWrapper& status) const
{
  const BridgeUpdate update = monitor_.newest();
  const bool full = update.report.load > kFullBus, lossy = update.bus.dropped > 0;
  status.summary(full || lossy || update.report.controller.passive ? DiagnosticStatus::WARN : DiagnosticStatus::OK,
                 full    ? "nearly full"
                 : lossy ? "frames were lost"
                         : controller_state(update.report.controller));
  if (update.report.stage == BridgeStage::link_down)
    status.summaryf(DiagnosticStatus::ERROR, "down: %s", update.bus_error.data());
  status.addf("load [%]", "%.1f", 100.0 * update.report.load);
  status.add("controller", controller_state(update.report.controller));
  status.add("transmit errors", static_cast<int>(update.report.controller.transmit_errors));
  status.add("receive errors", static_cast<int>(update.report.controller.receive_errors));
  status.add("sent", update.bus.sent);
  status.add("received", update.bus.received);
  status.add("found no room", update.bus.refused);
  status.add("overtaken before they were sent", update.report.replaced);
  status.add("dropped", update.bus.dropped);
  status.add("invalid", update.bus.invalid);
}

void BridgeDiagnostics::report_axis(int index, DiagnosticStatusWrapper& status) const
{
  const can::AxisReport axis = monitor_.newest().report.axes[static_cast<std::size_t>(index)];
  status.summary(level_of(axis), to_string(axis.drive));
  status.add("node", to_string(axis.node));
  status.addf("statusword", "0x%04x", axis.statusword);
  status.addf("last emergency", "0x%04x", axis.emergency);
  status.add(index < kWheels ? "angle [rad]" : "rolled [m]", axis.position);
  status.add(index < kWheels ? "rate [rad/s]" : "speed [m/s]", axis.speed);
  if (std::isfinite(axis.voltage)) status.add("supply [V]", axis.voltage);
  if (std::isfinite(axis.temperature)) status.add("temperature [deg C]", axis.temperature);
}

}  // namespace fourwis
