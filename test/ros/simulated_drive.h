#pragma once

#include <string>

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include "fourwis_navigation/InjectFault.h"
#include "fourwis_navigation/Tracking.h"
#include "inbox.h"
#include "ros/conversions.h"

namespace fourwis
{

using fourwis_navigation::InjectFault;
using fourwis_navigation::Tracking;

/// Speaks to the simulated robot of driving.launch and its controller, and keeps what they say.
class SimulatedDrive
{
protected:
  /// Returns when the simulator is there.
  void wait_for_base()
  {
    ASSERT_TRUE(wait_until([this] { return place_.getNumSubscribers() > 0 && truth_.connected(); }));
    ASSERT_TRUE(truth_.wait_for_any());
  }

  /// Returns when the localisation, which dates ahead, has the robot there.
  void place(const Pose& pose)
  {
    geometry_msgs::PoseWithCovarianceStamped message;
    message.header.frame_id = "map";
    message.pose.pose = to_message(pose);
    place_.publish(message);
    ASSERT_TRUE(wait_until([&] { return distance(truth(), pose) < 1e-6; }));
    pass(0.3);
  }

  /// Where the robot really is.
  Pose truth() const
  {
    const auto poses = truth_.messages();
    return poses.empty() ? Pose{} : to_pose(poses.back()->pose, "truth");
  }

  /// Lets simulated time pass [s].
  void pass(double seconds)
  {
    const ros::Time end = ros::Time::now() + ros::Duration(seconds);
    ASSERT_TRUE(wait_until([&] { return ros::Time::now() >= end; }));
  }

  Inbox<Tracking>::Pointer wait_for_tracking(const std::function<bool(const Tracking&)>& condition)
  {
    return tracking_.wait_for(condition);
  }
  Inbox<Tracking>::Pointer wait_for_state(std::uint8_t state, const ros::Time& trajectory)
  {
    return wait_for_tracking([&](const Tracking& t) { return t.state == state && t.trajectory == trajectory; });
  }
  /// Returns when the robot is fast on the trajectory.
  void wait_for_motion(const ros::Time& trajectory)
  {
    ASSERT_TRUE(wait_for_tracking([&](const Tracking& t) { return t.trajectory == trajectory && t.speed > 0.5; }));
  }
  /// Returns when the robot has not really moved for a while.
  void wait_for_rest()
  {
    ASSERT_TRUE(wait_until([this] {
      const auto poses = truth_.messages();
      const auto now = poses.rbegin();
      const auto is_a_while_ago = [&](const auto& pose) {
        return (*now)->header.stamp - pose->header.stamp >= ros::Duration(0.3);
      };
      const auto before = std::find_if(now, poses.rend(), is_a_while_ago);
      return before != poses.rend() &&
             distance(to_pose((*now)->pose, "now"), to_pose((*before)->pose, "before")) < 1e-4;
    }));
  }

  void expect_at(const Pose& goal) const
  {
    EXPECT_LT(distance(truth(), goal), 0.010);
    EXPECT_LT(std::abs(wrap_angle(truth().theta - goal.theta)), 0.5 * M_PI / 180.0);
  }

  InjectFault::Response inject(const InjectFault::Request& fault)
  {
    InjectFault call;
    call.request = fault;
    EXPECT_TRUE(ros::service::call("/base_simulator/inject_fault", call));
    return call.response;
  }
  InjectFault::Response inject(const std::string& kind, int wheel = 0)
  {
    InjectFault::Request fault;
    fault.kind = kind;
    fault.wheel = static_cast<std::uint8_t>(wheel);
    return inject(fault);
  }
  void repair()
  {
    std_srvs::Trigger call;
    ASSERT_TRUE(ros::service::call("/base_simulator/clear_faults", call));
  }

  Inbox<Tracking> tracking_{"mpc_controller/tracking"};
  Inbox<geometry_msgs::PoseStamped> truth_{"base_simulator/pose"};
  ros::Publisher place_ = ros::NodeHandle().advertise<geometry_msgs::PoseWithCovarianceStamped>("initialpose", 10);
};

}  // namespace fourwis
