#include "controller_diagnostics.h"

#include <algorithm>

#include "fourwis_navigation/model/fingerprint.h"
#include "tracking_marker.h"

namespace fourwis
{

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;
using fourwis_navigation::Tracking;

ControllerDiagnostics::ControllerDiagnostics(const Robot& robot) : fingerprint_(fingerprint(robot))
{
  updater_.setHardwareID("none");
  updater_.add("tracking", [this](DiagnosticStatusWrapper& status) { report(status); });
  timer_ = ros::NodeHandle().createWallTimer(ros::WallDuration(0.1),
                                             [this](const ros::WallTimerEvent&) { updater_.update(); });
}

void ControllerDiagnostics::stepped(const Tracking& tracking)
{
  if (last_ && last_->trajectory != tracking.trajectory) refusal_.clear();
  slowest_ms_ = std::max(slowest_ms_, tracking.solve_ms);
  last_ = tracking;
}

void ControllerDiagnostics::report(DiagnosticStatusWrapper& status)
{
  status.add("fingerprint of the robot", fingerprint_);
  if (!last_)
  {
    status.summary(DiagnosticStatus::WARN, "no odometry and wheel states of one stamp received yet");
    return;
  }
  const std::string complaint = last_->message.empty() ? refusal_ : last_->message;
  status.summary(complaint.empty() ? DiagnosticStatus::OK : DiagnosticStatus::WARN,
                 std::string(name_of(last_->state)) + (complaint.empty() ? "" : ": " + complaint));
  status.add("lateral error [m]", last_->lateral_error);
  status.add("longitudinal error [m]", last_->longitudinal_error);
  status.add("heading error [rad]", last_->heading_error);
  status.add("slowest step [ms]", slowest_ms_);
  slowest_ms_ = 0.0;
}

}  // namespace fourwis
