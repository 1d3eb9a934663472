#pragma once

#include <mutex>
#include <optional>
#include <string>

#include <ros/time.h>

#include "fourwis_navigation/Tracking.h"

namespace fourwis
{

/// What has become of the trajectory or the stop that the controller was sent last.
enum class DrivePhase
{
  none,     ///< nothing was sent, or the robot has stopped as it was told to
  pending,  ///< sent, not begun; of a stop: not at rest yet
  driving,
  arrived,  ///< at rest at the goal
  failed,   ///< at rest, given up by the controller
  lost      ///< refused or dropped by the controller; or that is silent or late, which may pass
};

struct DriveReport
{
  DrivePhase phase = DrivePhase::none;
  ros::Time since;      ///< stamp of the controller's first report of this phase
  double t = 0.0;       ///< where on the trajectory the robot is [s]
  std::string message;  ///< of `failed` and `lost`: why
};

/// Reduces the controller's reports to the phase of the drive. What has ended stays so until something else is sent. The
/// stamps in its answers are those of the reports; `now` only tells what does not come. Safe to use from several threads at once.
class DriveMonitor
{
public:
  /// `patience`: how long the controller may say nothing, begin late, or take to stop [s].
  explicit DriveMonitor(double patience) : patience_(patience) {}

  // To be called before it is published, with its header.stamp.
  void sending_trajectory(const ros::Time& stamp, const ros::Time& now) { sending(Kind::trajectory, stamp, now); }
  void sending_stop(const ros::Time& stamp, const ros::Time& now) { sending(Kind::stop, stamp, now); }

  /// A stamp farther from `now` than the patience counts as `now`.
  void reported(const fourwis_navigation::Tracking& tracking, const ros::Time& now);

  DriveReport report(const ros::Time& now) const;

  /// To be called when this process has been asleep until `now`: the controller's silence in that time was not its own.
  void slept_until(const ros::Time& now);

  /// header.stamp of the newest report of what is driven: the controller's own clock.
  ros::Time newest_stamp() const;

  /// Since when the robot stands still, with nothing before it that could begin; empty when it does not, or that is not known.
  std::optional<ros::Time> at_rest_since(const ros::Time& now) const;

  /// Whether the base has not let itself be driven at some time after `time`; and whether, for all that, it does now.
  bool disabled_since(const ros::Time& time) const;
  bool enabled_again_since(const ros::Time& time) const;

private:
  enum class Kind
  {
    nothing,
    stop,
    trajectory
  };

  void sending(Kind kind, const ros::Time& stamp, const ros::Time& now);
  void follow(const fourwis_navigation::Tracking& tracking, const ros::Time& stamp);
  void watch_rest(const fourwis_navigation::Tracking& tracking, const ros::Time& stamp);
  void watch_base(const fourwis_navigation::Tracking& tracking, const ros::Time& stamp);
  DrivePhase phase_after(const fourwis_navigation::Tracking& tracking) const;
  DrivePhase phase_of_ours(const fourwis_navigation::Tracking& tracking) const;
  bool rests(const fourwis_navigation::Tracking& tracking) const;
  bool ended() const;
  bool silent(const ros::Time& now) const { return now.toSec() - heard_.toSec() > patience_; }

  const double patience_;
  mutable std::mutex mutex_;
  Kind kind_ = Kind::nothing;
  ros::Time stamp_;  ///< of what was sent
  ros::Time due_;    ///< when it should begin
  ros::Time heard_;  ///< when the controller was last heard, or given something to say
  ros::Time newest_stamp_;
  std::string told_;     ///< the controller's last message
  bool enabled_ = true;  ///< whether the base lets itself be driven
  ros::Time disabled_;   ///< when it last did not; zero: never heard that it did not
  DriveReport report_;
  std::optional<ros::Time> rest_since_;
};

}  // namespace fourwis
