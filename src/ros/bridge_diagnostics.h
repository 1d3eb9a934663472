#pragma once

#include <atomic>
#include <cstdint>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/wall_timer.h>

#include "bridge_monitor.h"

namespace fourwis
{

/// On `/diagnostics`: the bridge and its faults, the bus, each of the eight axes. ERROR in fault, WARN where
/// something is not as it should be.
class BridgeDiagnostics
{
public:
  /// `monitor` must outlive this.
  BridgeDiagnostics(const BridgeMonitor& monitor, const std::string& interface);

  /// A command came so late that it was thrown away. Any thread.
  void late_command() { ++late_commands_; }

private:
  void report_bridge(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void report_bus(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  void report_axis(int axis, diagnostic_updater::DiagnosticStatusWrapper& status) const;

  const BridgeMonitor& monitor_;
  std::atomic<std::uint64_t> late_commands_{0};
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

/// What is the matter with a bridge, in a line; empty when it is enabled.
std::string explanation(const can::BridgeReport& report);

}  // namespace fourwis
