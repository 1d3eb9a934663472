#include "fourwis_navigation/ros/drive_monitor.h"

#include <algorithm>
#include <sstream>

#include "fourwis_navigation/ros/plausible_stamp.h"

namespace fourwis
{
namespace
{

using fourwis_navigation::Tracking;

DriveReport lost(const std::string& what, double patience)
{
  std::ostringstream message;
  message << "the controller " << what << " for " << patience << " s";
  return {DrivePhase::lost, {}, 0.0, message.str()};
}

std::string why(DrivePhase phase, const Tracking& tracking)
{
  if (phase == DrivePhase::failed) return tracking.message;
  if (phase == DrivePhase::lost) return "the controller has dropped the trajectory: restarted, or sent another one";
  return "";
}

}  // namespace

void DriveMonitor::sending(Kind kind, const ros::Time& stamp, const ros::Time& now)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  kind_ = kind;
  stamp_ = stamp;
  due_ = heard_ = std::max(stamp, now);
  report_ = {DrivePhase::pending, now, 0.0, {}};
  rest_since_.reset();
}

void DriveMonitor::reported(const Tracking& tracking, const ros::Time& now)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const ros::Time stamp = plausible(tracking.header.stamp, now, patience_);
  heard_ = std::max(heard_, now);
  const DrivePhase phase = ended() ? report_.phase : phase_after(tracking);
  if (phase != report_.phase) report_ = {phase, stamp, report_.t, why(phase, tracking)};
  if (phase == DrivePhase::driving) report_.t = tracking.t;

  if (!rests(tracking))
    rest_since_.reset();
  else if (!rest_since_)
    rest_since_ = stamp;
}

DrivePhase DriveMonitor::phase_after(const Tracking& tracking) const
{
  if (kind_ != Kind::trajectory) return rests(tracking) ? DrivePhase::none : report_.phase;
  if (tracking.trajectory != stamp_)
    return report_.phase == DrivePhase::pending ? DrivePhase::pending : DrivePhase::lost;
  switch (tracking.state)
  {
    case Tracking::ARRIVED: return DrivePhase::arrived;
    case Tracking::FAILED: return DrivePhase::failed;
    case Tracking::IDLE: return DrivePhase::lost;
    default: return DrivePhase::driving;
  }
}

bool DriveMonitor::rests(const Tracking& tracking) const
{
  if (tracking.state != Tracking::IDLE && tracking.state != Tracking::ARRIVED && tracking.state != Tracking::FAILED)
    return false;
  // A controller that started after the stop was sent has not taken it, and does not need it.
  return tracking.trajectory == stamp_ || ended() || kind_ == Kind::nothing ||
         (kind_ == Kind::stop && tracking.trajectory.isZero());
}

bool DriveMonitor::ended() const
{
  return report_.phase == DrivePhase::arrived || report_.phase == DrivePhase::failed ||
         report_.phase == DrivePhase::lost;
}

DriveReport DriveMonitor::report(const ros::Time& now) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool pending = report_.phase == DrivePhase::pending;
  if (!pending && report_.phase != DrivePhase::driving) return report_;
  if (silent(now)) return lost("has not been heard on topic 'tracking'", patience_);
  if (!pending || now.toSec() - due_.toSec() <= patience_) return report_;
  return lost(kind_ == Kind::stop ? "has not come to rest" : "has not begun the trajectory", patience_);
}

std::optional<ros::Time> DriveMonitor::at_rest_since(const ros::Time& now) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return silent(now) ? std::nullopt : rest_since_;
}

}  // namespace fourwis
