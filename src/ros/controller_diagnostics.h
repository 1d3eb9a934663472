#pragma once

#include <optional>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/wall_timer.h>

#include "fourwis_navigation/Tracking.h"
#include "fourwis_navigation/model/robot.h"

namespace fourwis
{

/// On `/diagnostics`: what the controller is doing and how well, WARN where it stops or fails for a reason or refused
/// the last trajectory.
class ControllerDiagnostics
{
public:
  explicit ControllerDiagnostics(const Robot& robot);

  void stepped(const fourwis_navigation::Tracking& tracking);
  void refused(const std::string& message) { refusal_ = message; }

private:
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  const std::string fingerprint_;  ///< of the robot
  std::optional<fourwis_navigation::Tracking> last_;
  std::string refusal_;      ///< of the trajectory that came last; empty when it was taken
  double slowest_ms_ = 0.0;  ///< control step since the last report
  diagnostic_updater::Updater updater_;
  ros::WallTimer timer_;
};

}  // namespace fourwis
