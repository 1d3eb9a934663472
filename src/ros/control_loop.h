#pragma once

#include <functional>
#include <optional>
#include <string>

#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <tf2/buffer_core.h>

#include "fourwis_navigation/DrivePermit.h"
#include "fourwis_navigation/ModeTrajectory.h"
#include "fourwis_navigation/WheelStates.h"
#include "fourwis_navigation/parameters/node_parameters.h"
#include "fourwis_navigation/track/tracker.h"
#include "fourwis_navigation/vehicle/base_link.h"
#include "odometry_pose.h"

namespace fourwis
{

/// What came of one control step.
struct ControlStep
{
  ros::Time stamp;        ///< of the measurements it answers, or when it found them stale
  ros::Time trajectory;   ///< header.stamp of the trajectory or stop that was begun last; zero for none
  TrackOutput output;     ///< its message is valid until the next step
  bool enabled = false;   ///< whether the base lets itself be driven
  std::string problem;    ///< why the pose is not known, or why the base says that it is not enabled; empty otherwise
  double speed = 0.0;     ///< of the robot's centre, as odometry has it [m/s]
  double solve_ms = 0.0;  ///< time of the whole step
};

/// The controller's node without its topics: judges trajectories, and steps the tracker whenever odometry and wheel
/// states of one stamp say that it is time. Its clock is their stamps, so that recorded messages give the recorded
/// commands. To be called from one thread.
class ControlLoop
{
public:
  /// Called with the header.stamp of a trajectory that is not driven, and why not in a sentence.
  using Refused = std::function<void(const ros::Time&, const std::string&)>;

  /// `tf` must outlive this.
  ControlLoop(const MpcControllerParameters& parameters, const tf2::BufferCore& tf, Refused refused);

  /// A trajectory begins, and an empty one stops, with the first step that is not before its stamp. What comes while a
  /// stop waits does not postpone it. Refused: one in another frame or for another robot, one that the tracker refuses,
  /// one stamped before this loop's first measurement (it is left over from an earlier drive) or far ahead of the newest.
  /// Returns whether it is not refused right away.
  bool take(const fourwis_navigation::ModeTrajectory& trajectory);

  /// Two messages of one stamp. Empty when it is not time for a step yet. Begins anew when time went back by more than
  /// kClockSetBack; what is only late is not taken.
  std::optional<ControlStep> measured(const nav_msgs::Odometry& odometry,
                                      const fourwis_navigation::WheelStates& wheels);

  /// A permit for the trajectory that is driven, or that comes next. One for another does nothing, nor does one that is older than
  /// the last.
  void take_permit(const fourwis_navigation::DrivePermit& permit);

  // Stamps of what arrives, paired or not: only to say what is missing.
  void heard_odometry(const ros::Time& stamp) { newest_odometry_ = stamp; }
  void heard_wheel_states(const ros::Time& stamp) { newest_wheel_states_ = stamp; }

  /// Steps on what was measured last once that is older than the tracker accepts, so that it stops. Empty otherwise,
  /// and before the first measurement.
  std::optional<ControlStep> watch(const ros::Time& now);

  /// Whether there was a measurement yet.
  bool has_measured() const { return !first_.isZero(); }

  const std::vector<Pose>& prediction() const { return tracker_->prediction(); }

private:
  struct WaitingStop
  {
    ros::Time stamp;
    ros::Time due;  ///< its own stamp, or that of a stop before it that it stands for as well
  };
  struct WaitingTrajectory
  {
    ros::Time stamp;
    Trajectory trajectory;
  };

  void restart(double back);
  void take_stop(const ros::Time& stamp);
  void take_to_drive(const fourwis_navigation::ModeTrajectory& trajectory);
  void check(const std_msgs::Header& header) const;
  void check_robot(const std::string& planned_for) const;
  void stop_or_start(const ros::Time& now);
  void start(const WaitingTrajectory& due);
  void locate(const nav_msgs::Odometry& odometry);
  DrivePermission permission(const ros::Time& now) const;
  ControlStep step(const ros::Time& now);

  const MpcControllerParameters parameters_;
  const std::string fingerprint_;  ///< of the robot
  const BaseLink base_link_;
  const OdometryPose odometry_pose_;
  const Refused refused_;
  std::optional<Tracker> tracker_;  ///< replaced when time goes back
  std::optional<WaitingStop> stop_;
  std::optional<WaitingTrajectory> next_;
  ros::Time trajectory_;      ///< stamp of what the tracker was told last: a trajectory or a stop
  ros::Time first_, newest_;  ///< pair
  ros::Time newest_odometry_, newest_wheel_states_;
  ros::Time stepped_;         ///< the last step
  std::uint64_t number_ = 0;  ///< of it
  TrackInput input_;
  fourwis_navigation::DrivePermit permit_;  ///< the last one
  double speed_ = 0.0;
  std::string problem_;
};

}  // namespace fourwis
