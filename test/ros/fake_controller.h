#pragma once

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2_msgs/TFMessage.h>

#include "fourwis_navigation/ModeTrajectory.h"
#include "fourwis_navigation/Tracking.h"
#include "ros/conversions.h"

namespace fourwis
{

/// Stands in for controller, base and clock, ten times as fast as real time: is exactly where the trajectory wants it to be,
/// says so on `tracking` and by tf, and fails as a test asks it to.
class FakeController
{
public:
  FakeController()
  {
    subscriber_ = node_.subscribe<fourwis_navigation::ModeTrajectory>(
        "trajectory", 100, [this](const fourwis_navigation::ModeTrajectoryConstPtr& trajectory) { take(trajectory); });
    thread_ = std::thread([this] { run(); });
  }
  ~FakeController()
  {
    ended_ = true;
    thread_.join();
  }

  /// At rest, without a trajectory, without a failure.
  void reset(const Pose& pose)
  {
    const Lock lock(mutex_);
    pose_ = pose;
    trajectory_.reset();
    taken_ = ros::Time();
    state_ = Tracking::IDLE;
    hold_ = fail_ = kNever;
    disabled_in_.reset();
    silent_ = unstoppable_ = surprised_ = false;
  }

  Pose pose() const
  {
    const Lock lock(mutex_);
    return pose_;
  }

  bool rests() const
  {
    const Lock lock(mutex_);
    return state_ != Tracking::DRIVING && state_ != Tracking::STOPPING;
  }

  /// Whether there was something to drive before it had come to rest.
  bool surprised() const
  {
    const Lock lock(mutex_);
    return surprised_;
  }

  // All in seconds of the trajectory; each lasts until the next reset().
  void hold_at(double t) { set(hold_, t); }  ///< drives on the spot there
  void release() { set(hold_, kNever); }
  void fail_at(double t) { set(fail_, t); }  ///< gives up there, every time

  /// Gives up there; from then on the base is reported as not enabled.
  void disable_base_at(double t)
  {
    set(disabled_in_, std::optional<std::uint8_t>(Tracking::FAILED));
    fail_at(t);
  }
  /// The base is not enabled while the robot comes to rest, and is when it rests.
  void disable_base_while_stopping() { set(disabled_in_, std::optional<std::uint8_t>(Tracking::STOPPING)); }

  void fall_silent() { set(silent_, true); }
  void be_unstoppable() { set(unstoppable_, true); }
  /// Says that it does not drive the trajectory of this stamp.
  void refuse(const ros::Time& trajectory)
  {
    Tracking refused;
    refused.header.stamp = now_;
    refused.state = Tracking::REFUSED;
    refused.trajectory = trajectory;
    refused.message = "refused";
    tracking_.publish(refused);
  }
  /// As when the node dies and comes up again: it gets the latched trajectory, and refuses it before it says anything else.
  void restart()
  {
    const Lock lock(mutex_);
    refuse(taken_);
    trajectory_.reset();
    taken_ = ros::Time();
    state_ = Tracking::IDLE;
  }

private:
  using Lock = std::lock_guard<std::mutex>;
  using Tracking = fourwis_navigation::Tracking;
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static constexpr double kStep = 0.01;      // [s]
  static constexpr double kStopping = 0.25;  // [s]

  template <class Value>
  void set(Value& member, Value value)
  {
    const Lock lock(mutex_);
    member = value;
  }

  void take(const fourwis_navigation::ModeTrajectoryConstPtr& trajectory)
  {
    const Lock lock(mutex_);
    trajectory_ = trajectory;
  }

  void run()
  {
    for (; !ended_; ros::WallDuration(kStep / 10.0).sleep())
    {
      const Lock lock(mutex_);
      now_ += ros::Duration(kStep);
      step();
      publish();
    }
  }

  void step()
  {
    if (trajectory_ && trajectory_->header.stamp <= now_ && taken_ != trajectory_->header.stamp) begin();
    if (state_ == Tracking::STOPPING && now_ >= rest_) state_ = Tracking::IDLE;
    if (state_ == Tracking::DRIVING) follow();
  }

  void begin()
  {
    const bool stops = trajectory_->points.empty();
    if (unstoppable_ && stops) return;
    if (!stops && (state_ == Tracking::DRIVING || state_ == Tracking::STOPPING)) surprised_ = true;
    driven_ = trajectory_;
    taken_ = trajectory_->header.stamp;
    t_ = 0.0;
    message_.clear();
    // Like the controller, which has nothing to stop when it rests.
    const bool rested = state_ != Tracking::DRIVING && state_ != Tracking::STOPPING;
    state_ = !stops ? Tracking::DRIVING : rested ? Tracking::IDLE : Tracking::STOPPING;
    rest_ = now_ + ros::Duration(kStopping);
  }

  void follow()
  {
    const auto& points = driven_->points;
    t_ = std::min(t_ + kStep, hold_);
    std::size_t next = 1;
    while (next + 1 < points.size() && points[next].t < t_) ++next;
    if (points.size() > 1) go_between(points[next - 1], points[next]);
    if (t_ >= points.back().t) state_ = Tracking::ARRIVED;
    if (t_ < fail_) return;
    state_ = Tracking::FAILED;
    message_ = "off the path by 0.3 m";
  }

  void go_between(const fourwis_navigation::TrajectoryPoint& from, const fourwis_navigation::TrajectoryPoint& to)
  {
    const double share = std::min(1.0, (t_ - from.t) / (to.t - from.t));
    pose_ = {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y),
             from.theta + share * (to.theta - from.theta)};
  }

  void publish()
  {
    rosgraph_msgs::Clock clock;
    clock.clock = now_;
    clock_.publish(clock);
    geometry_msgs::TransformStamped transform;
    transform.header.stamp = now_;
    transform.header.frame_id = "map";
    transform.child_frame_id = "base_link";
    transform.transform.translation.x = pose_.x;
    transform.transform.translation.y = pose_.y;
    transform.transform.rotation = to_message(pose_).orientation;
    tf2_msgs::TFMessage tf;
    tf.transforms.push_back(transform);
    tf_.publish(tf);
    if (silent_) return;
    Tracking tracking;
    tracking.header.stamp = now_;
    tracking.state = state_;
    tracking.trajectory = taken_;
    tracking.message = message_;
    tracking.enabled = disabled_in_ != state_;
    tracking.t = t_;
    tracking_.publish(tracking);
  }

  ros::NodeHandle node_;
  ros::Publisher clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 10);
  ros::Publisher tf_ = node_.advertise<tf2_msgs::TFMessage>("/tf", 100);
  ros::Publisher tracking_ = node_.advertise<Tracking>("tracking", 100);
  ros::Subscriber subscriber_;

  mutable std::mutex mutex_;
  ros::Time now_{1000.0}, rest_;
  Pose pose_;
  fourwis_navigation::ModeTrajectoryConstPtr trajectory_, driven_;  ///< that came last; that is driven
  ros::Time taken_;
  std::uint8_t state_ = Tracking::IDLE;
  std::string message_;
  double t_ = 0.0, hold_ = kNever, fail_ = kNever;
  std::optional<std::uint8_t> disabled_in_;  ///< state in which the base is not enabled
  bool silent_ = false, unstoppable_ = false, surprised_ = false;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace fourwis
