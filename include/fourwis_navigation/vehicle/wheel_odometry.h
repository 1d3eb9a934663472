#pragma once

#include <Eigen/Core>

#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/model/wheels.h"
#include "fourwis_navigation/vehicle/wheel_twist.h"

namespace fourwis
{

/// Where the body is according to its wheels.
struct Odometry
{
  double stamp = 0.0;                                         ///< of the last measurement [s]
  Pose pose;                                                  ///< in the odom frame; theta is not wrapped
  Eigen::Matrix3d pose_covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, theta) in the odom frame
  TwistEstimate motion;                                       ///< at the stamp
};

/// What became of a measurement.
enum class OdometryStatus
{
  first,  ///< begins a sequence: nothing to integrate yet
  integrated,
  not_newer,   ///< refused: its stamp is not later than the last one
  not_finite,  ///< refused: something in it is no number
  gap          ///< begins a new sequence: the interval is too long to know the motion in it
};

/// Integrates the twists of the wheels: over each interval the mean of the twists at its ends, on the exact arc. The
/// covariance grows with the motion. No allocation.
class WheelOdometry
{
public:
  /// No motion is integrated over more than `longest_interval` [s]. Throws as check() does, and std::invalid_argument unless that
  /// is positive and finite.
  WheelOdometry(const Robot& robot, const WheelTwistOptions& options, double longest_interval = 0.5);

  /// Takes what was measured at `stamp` [s]. What is refused changes nothing.
  OdometryStatus update(double stamp, const WheelMotion& wheels);

  const Odometry& state() const { return state_; }

  /// Sets the pose of the body, without uncertainty. It may jump.
  void set_pose(const Pose& pose);

private:
  OdometryStatus judge(double stamp, const WheelMotion& wheels) const;
  void integrate(const Twist& mean, double interval, const Eigen::Matrix3d& twist_covariance);

  WheelTwist twist_;
  double longest_interval_;
  bool begun_ = false;
  PerWheel last_angle_{};
  Odometry state_;
};

}  // namespace fourwis
