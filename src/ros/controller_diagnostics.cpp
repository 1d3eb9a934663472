#include "fourwis_navigation/ros/controller_diagnostics.h"

#include "fourwis_navigation/ros/controller_topics.h"

namespace fourwis
{

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_updater::DiagnosticStatusWrapper;

namespace
{

const char* to_string(TrackState state)
{
  switch (state)
  {
    case TrackState::idle: return "no trajectory";
    case TrackState::aligning: return "turning the wheels";
    case TrackState::driving: return "driving";
    case TrackState::stopping: return "stopping";
    case TrackState::arrived: return "arrived";
    case TrackState::failed: return "gave up";
  }
  return "";
}

}  // namespace

ControllerDiagnostics::ControllerDiagnostics()
{
  updater_.setHardwareID("none");
  updater_.add("tracking", [this](DiagnosticStatusWrapper& status) { report(status); });
  timer_ = ros::NodeHandle().createWallTimer(ros::WallDuration(0.1),
                                             [this](const ros::WallTimerEvent&) { updater_.update(); });
}

void ControllerDiagnostics::stepped(const ControlStep& step)
{
  if (last_ && last_->trajectory != step.trajectory) refusal_.clear();
  greatest_solve_ms_ = std::max(greatest_solve_ms_, step.solve_ms);
  last_ = step;
}

void ControllerDiagnostics::report(DiagnosticStatusWrapper& status)
{
  if (!last_)
  {
    status.summary(DiagnosticStatus::WARN, "no odometry and wheel states of one stamp received yet");
    return;
  }
  const fourwis_navigation::Tracking tracking = to_message(*last_, "");
  const std::string complaint = tracking.message.empty() ? refusal_ : tracking.message;
  status.summary(complaint.empty() ? DiagnosticStatus::OK : DiagnosticStatus::WARN,
                 std::string(to_string(last_->output.state)) + (complaint.empty() ? "" : ": " + complaint));
  status.add("lateral error [m]", tracking.lateral_error);
  status.add("longitudinal error [m]", tracking.longitudinal_error);
  status.add("heading error [rad]", tracking.heading_error);
  status.add("slowest step [ms]", greatest_solve_ms_);
  greatest_solve_ms_ = 0.0;
}

}  // namespace fourwis
