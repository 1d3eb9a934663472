#pragma once

#include <optional>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/wall_timer.h>

#include "fourwis_navigation/ros/control_loop.h"

namespace fourwis
{

/// On `/diagnostics`: what the controller is doing and how well, WARN where it stops or fails for a reason or refused the
/// last trajectory.
class ControllerDiagnostics
{
public:
  ControllerDiagnostics();

  void stepped(const ControlStep& step);
  void refused(const std::string& message) { refusal_ = message; }

private:
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  std::optional<ControlStep> last_;
  std::string refusal_;         ///< of the trajectory that came last; empty when it was taken
  double greatest_solve_ms_ = 0.0;  ///< since the last report
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace fourwis
