#include "fourwis_navigation/vehicle/wheel_odometry.h"

#include <algorithm>
#include <cmath>

#include "fourwis_navigation/model/option_range.h"

namespace fourwis
{
namespace
{

bool all_finite(const PerWheel& values)
{
  return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

PerWheel rates(const PerWheel& from, const PerWheel& to, double interval)
{
  PerWheel rate{};
  for (std::size_t i = 0; i < rate.size(); ++i) rate[i] = (to[i] - from[i]) / interval;
  return rate;
}

Twist mean(const Twist& a, const Twist& b)
{
  return {(a.vx + b.vx) / 2.0, (a.vy + b.vy) / 2.0, (a.omega + b.omega) / 2.0};
}

}  // namespace

WheelOdometry::WheelOdometry(const Robot& robot, const WheelTwistOptions& options, double longest_interval)
  : twist_(robot, options),
    longest_interval_(longest_interval)
{
  require_positive("longest_interval", longest_interval);
}

OdometryStatus WheelOdometry::update(double stamp, const WheelMotion& wheels)
{
  const OdometryStatus status = judge(stamp, wheels);
  if (status == OdometryStatus::not_finite || status == OdometryStatus::not_newer) return status;

  const double interval = stamp - state_.stamp;
  const bool integrable = status == OdometryStatus::integrated;
  const TwistEstimate motion =
      twist_.estimate(wheels, integrable ? rates(last_angle_, wheels.angle, interval) : PerWheel{});
  if (integrable) integrate(mean(state_.motion.twist, motion.twist), interval, motion.covariance);
  begun_ = true;
  last_angle_ = wheels.angle;
  state_.stamp = stamp;
  state_.motion = motion;
  return status;
}

OdometryStatus WheelOdometry::judge(double stamp, const WheelMotion& wheels) const
{
  const bool finite = std::isfinite(stamp) && all_finite(wheels.angle) && all_finite(wheels.speed);
  if (!finite) return OdometryStatus::not_finite;
  if (!begun_) return OdometryStatus::first;
  if (stamp <= state_.stamp) return OdometryStatus::not_newer;
  return stamp - state_.stamp <= longest_interval_ ? OdometryStatus::integrated : OdometryStatus::gap;
}

void WheelOdometry::set_pose(const Pose& pose)
{
  state_.pose = pose;
  state_.pose_covariance.setZero();
}

void WheelOdometry::integrate(const Twist& mean, double interval, const Eigen::Matrix3d& twist_covariance)
{
  const Pose before = state_.pose;
  state_.pose = move(before, mean, interval);

  // An error of the heading before rotates the motion since then. Errors of the twist act along the heading in the
  // middle.
  Eigen::Matrix3d transition = Eigen::Matrix3d::Identity();
  transition(0, 2) = -(state_.pose.y - before.y);
  transition(1, 2) = state_.pose.x - before.x;
  const double middle = before.theta + mean.omega * interval / 2.0, c = std::cos(middle), s = std::sin(middle);
  Eigen::Matrix3d input;
  input << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
  input *= interval;
  state_.pose_covariance =
      transition * state_.pose_covariance * transition.transpose() + input * twist_covariance * input.transpose();
}

}  // namespace fourwis
