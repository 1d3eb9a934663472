#include "control_loop.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include <ros/console.h>

#include "drive_conversions.h"
#include "fourwis_navigation/model/fingerprint.h"
#include "fourwis_navigation/model/sentence.h"
#include "fourwis_navigation/track/step_number.h"
#include "stamps.h"

namespace fourwis
{
namespace
{

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// A trajectory that begins later than this was stamped by another clock [s]. A stop that begins later does not wait.
constexpr double kLongestWait = 10.0, kLongestWaitOfStop = 1.0;

bool is_stop_due(const ros::Time& due, const ros::Time& now)
{
  return due <= now || seconds_between(now, due) > kLongestWaitOfStop;
}

}  // namespace

ControlLoop::ControlLoop(const MpcControllerParameters& parameters, const tf2::BufferCore& tf, Refused refused)
  : parameters_(parameters),
    fingerprint_(fingerprint(parameters.robot)),
    base_link_(parameters.robot),
    odometry_pose_(parameters.node.global_frame, parameters.node.robot_base_frame, parameters.node.transform_tolerance,
                   tf),
    refused_(std::move(refused))
{
  tracker_.emplace(parameters.robot, parameters.track);
}

bool ControlLoop::take(const fourwis_navigation::ModeTrajectory& trajectory)
{
  try
  {
    if (trajectory.points.empty())
      take_stop(trajectory.header.stamp);
    else
      take_to_drive(trajectory);
    return true;
  }
  catch (const ConversionError& error)
  {
    refused_(trajectory.header.stamp, error.what());
    return false;
  }
}

void ControlLoop::take_stop(const ros::Time& stamp)
{
  next_.reset();
  stop_ = WaitingStop{stamp, stop_ ? std::min(stop_->due, stamp) : stamp};
}

void ControlLoop::take_to_drive(const fourwis_navigation::ModeTrajectory& trajectory)
{
  check(trajectory.header);
  check_robot(trajectory.fingerprint);
  next_ = WaitingTrajectory{trajectory.header.stamp, base_link_.to_centre(to_trajectory(trajectory))};
}

void ControlLoop::check(const std_msgs::Header& header) const
{
  if (header.frame_id != parameters_.node.global_frame)
    reject<ConversionError>("trajectory: header.frame_id is '", header.frame_id, "', expected global_frame = '",
                            parameters_.node.global_frame, "'");
  if (first_.isZero()) reject<ConversionError>("trajectory: came before odometry and wheel states of one stamp");
  if (header.stamp < first_)
    reject<ConversionError>("trajectory: was planned ", seconds_between(header.stamp, first_),
                            " s before the controller started");
  if (const double wait = seconds_between(newest_, header.stamp); wait > kLongestWait)
    reject<ConversionError>("trajectory: is to begin ", wait, " s after the newest odometry, expected at most ",
                            kLongestWait, " s");
}

void ControlLoop::check_robot(const std::string& planned_for) const
{
  if (planned_for == fingerprint_) return;
  reject<ConversionError>("trajectory: ", planned_for.empty() ? "names no robot" : "was planned for another robot",
                          ": fingerprint is '", planned_for, "', expected '", fingerprint_,
                          "', that of the controller's robot; give planner and controller the same robot.yaml");
}

std::optional<ControlStep> ControlLoop::measured(const nav_msgs::Odometry& odometry,
                                                 const fourwis_navigation::WheelStates& wheels)
{
  const ros::Time now = odometry.header.stamp;
  const double back = seconds_between(now, newest_);
  if (back > kClockSetBack) restart(back);
  if (now < newest_) return std::nullopt;
  if (first_.isZero()) first_ = now;
  newest_ = now;
  const std::uint64_t number = step_number(now.toSec(), parameters_.track.controller_frequency);
  if (number == number_ || now <= stepped_) return std::nullopt;
  number_ = number;
  locate(odometry);
  if (problem_.empty() && wheels.state != fourwis_navigation::WheelStates::ENABLED) problem_ = wheels.message;
  input_.wheels = to_wheel_state(wheels);
  return step(now);
}

std::optional<ControlStep> ControlLoop::watch(const ros::Time& now)
{
  const double patience = std::min(parameters_.track.pose_timeout, parameters_.track.wheel_state_timeout);
  const auto age = [&](const ros::Time& stamp) { return seconds_between(stamp, now); };
  if (first_.isZero() || age(newest_) <= patience) return std::nullopt;
  problem_ = "no odom and wheel_states of one stamp, they are " + std::to_string(age(newest_odometry_)) + " s and " +
             std::to_string(age(newest_wheel_states_)) + " s old";
  return step(now);
}

void ControlLoop::restart(double back)
{
  ROS_WARN("time went back by %.3f s: forgetting what was to be driven", back);
  tracker_.emplace(parameters_.robot, parameters_.track);
  stop_.reset();
  next_.reset();
  permit_ = {};
  trajectory_ = first_ = newest_ = stepped_ = ros::Time();
  number_ = 0;
}

void ControlLoop::locate(const nav_msgs::Odometry& odometry)
{
  problem_.clear();
  const geometry_msgs::Twist& twist = odometry.twist.twist;
  const Twist centre = base_link_.to_centre(Twist{twist.linear.x, twist.linear.y, twist.angular.z});
  speed_ = std::hypot(centre.vx, centre.vy);
  input_.pose_stamp = odometry.header.stamp.toSec();
  try
  {
    input_.pose = base_link_.to_centre(odometry_pose_.at(odometry));
  }
  catch (const ConversionError& error)
  {
    input_.pose = {kUnknown, kUnknown, kUnknown};
    problem_ = error.what();
  }
}

void ControlLoop::stop_or_start(const ros::Time& now)
{
  const bool starts = next_ && next_->stamp <= now;
  if (stop_ && (starts || is_stop_due(stop_->due, now)))
  {
    tracker_->stop();
    trajectory_ = stop_->stamp;
    stop_.reset();
  }
  if (starts) start(*std::exchange(next_, std::nullopt));
}

void ControlLoop::start(const WaitingTrajectory& due)
{
  if (const std::string refusal = tracker_->accept(due.trajectory); !refusal.empty())
    return refused_(due.stamp, refusal);
  trajectory_ = due.stamp;
}

void ControlLoop::take_permit(const fourwis_navigation::DrivePermit& permit)
{
  const bool is_ours = permit.trajectory == trajectory_ || (next_ && permit.trajectory == next_->stamp);
  const bool is_late = permit.trajectory == permit_.trajectory && permit.heard < permit_.heard;
  if (is_ours && !is_late) permit_ = permit;
}

/// A permit that tells a stamp which this controller has not sent yet is none.
DrivePermission ControlLoop::permission(const ros::Time& now) const
{
  if (!parameters_.node.require_permit) return {};
  const double age = seconds_between(permit_.heard, now);
  if (permit_.trajectory != trajectory_ || permit_.heard.isZero() || !(age >= 0.0))
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  return {permit_.free_until, age};
}

ControlStep ControlLoop::step(const ros::Time& now)
{
  using Clock = std::chrono::steady_clock;
  stop_or_start(now);
  stepped_ = now;
  ControlStep result;
  result.stamp = now;
  result.trajectory = trajectory_;
  result.problem = problem_;
  result.enabled = input_.wheels.state == BaseState::enabled;
  result.speed = speed_;
  input_.now = now.toSec();
  input_.permission = permission(now);
  const Clock::time_point start = Clock::now();
  result.output = tracker_->step(input_);
  result.solve_ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  return result;
}

}  // namespace fourwis
