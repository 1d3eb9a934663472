#include "drive_monitor.h"

#include <algorithm>

#include "fourwis_navigation/model/sentence.h"
#include "plausible_stamp.h"

namespace fourwis
{
namespace
{

using fourwis_navigation::Tracking;

DriveReport lost(const std::string& what, double patience, const std::string& reason = "")
{
  const char* const colon = reason.empty() ? "" : ": ";
  return {DrivePhase::lost, {}, 0.0, joined("the controller ", what, " for ", patience, " s", colon, reason)};
}

std::string why(DrivePhase phase, const Tracking& tracking)
{
  if (phase == DrivePhase::failed) return tracking.message;
  if (phase != DrivePhase::lost) return "";
  if (tracking.state == Tracking::REFUSED) return tracking.message;
  return "the controller has dropped the trajectory: restarted, or sent another one";
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
  heard_ = now;
  told_ = tracking.message;
  if (!ended()) follow(tracking, stamp);
  if (tracking.state == Tracking::REFUSED) return;
  newest_stamp_ = tracking.header.stamp;
  watch_rest(tracking, stamp);
  watch_base(tracking, stamp);
}

void DriveMonitor::follow(const Tracking& tracking, const ros::Time& stamp)
{
  const DrivePhase phase = phase_after(tracking);
  if (phase != report_.phase) report_ = {phase, stamp, report_.t, why(phase, tracking)};
  // At rest there is no answer to where on the trajectory: it is where it was.
  if (phase == DrivePhase::driving) report_.t = std::max(report_.t, tracking.t);
}

void DriveMonitor::watch_rest(const Tracking& tracking, const ros::Time& stamp)
{
  if (rests(tracking))
    rest_since_ = std::min(rest_since_.value_or(stamp), stamp);
  else
    rest_since_.reset();
}

void DriveMonitor::watch_base(const Tracking& tracking, const ros::Time& stamp)
{
  enabled_ = tracking.enabled;
  disabled_ = enabled_ ? std::min(disabled_, stamp) : stamp;
}

DrivePhase DriveMonitor::phase_after(const Tracking& tracking) const
{
  if (kind_ != Kind::trajectory) return rests(tracking) ? DrivePhase::none : report_.phase;
  if (tracking.trajectory == stamp_) return phase_of_ours(tracking);
  const bool drives_another = tracking.state != Tracking::REFUSED && report_.phase != DrivePhase::pending;
  return drives_another ? DrivePhase::lost : report_.phase;
}

DrivePhase DriveMonitor::phase_of_ours(const Tracking& tracking) const
{
  switch (tracking.state)
  {
    case Tracking::ARRIVED: return DrivePhase::arrived;
    case Tracking::FAILED: return DrivePhase::failed;
    case Tracking::IDLE:
    case Tracking::REFUSED: return DrivePhase::lost;
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
  return lost(kind_ == Kind::stop ? "has not come to rest" : "has not begun the trajectory", patience_, told_);
}

void DriveMonitor::slept_until(const ros::Time& now)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  heard_ = std::max(heard_, now);
  due_ = std::max(due_, now);
}

ros::Time DriveMonitor::newest_stamp() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return newest_stamp_;
}

std::optional<ros::Time> DriveMonitor::at_rest_since(const ros::Time& now) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return silent(now) ? std::nullopt : rest_since_;
}

bool DriveMonitor::disabled_since(const ros::Time& time) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return disabled_ > time;
}

bool DriveMonitor::enabled_again_since(const ros::Time& time) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return enabled_ && disabled_ > time;
}

}  // namespace fourwis
