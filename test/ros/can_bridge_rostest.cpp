#include <cmath>
#include <memory>
#include <thread>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>

#include "fourwis_navigation/InjectFault.h"
#include "fourwis_navigation/WheelCommands.h"
#include "fourwis_navigation/WheelStates.h"
#include "inbox.h"
#include "node_process.h"
#include "ros/base_topics.h"
#include "run_rostest.h"

namespace fourwis
{
namespace
{

using diagnostic_msgs::DiagnosticArray;
using diagnostic_msgs::DiagnosticStatus;
using fourwis_navigation::InjectFault;
using fourwis_navigation::WheelCommands;
using fourwis_navigation::WheelStates;

TEST(BaseTopics, clocks_that_are_set_back_do_not_hold_odometry_back)
{
  Inbox<sensor_msgs::JointState> joints("joint_states");
  BaseTopics topics{Robot(), BaseFrames()};
  ASSERT_TRUE(wait_until([&] { return joints.connected(); }));
  WheelState state;
  state.motion.speed.fill(1.0);
  for (const double wall : {1000.0, 940.0})
  {
    state.stamp += 0.01;
    topics.publish(ros::Time(wall), state, "");
  }
  EXPECT_NEAR(topics.odometry().x, 0.01, 1e-9);
  ASSERT_TRUE(wait_until([&] { return joints.messages().size() == 2; }));
  const auto &before = *joints.messages()[0], &after = *joints.messages()[1];
  EXPECT_EQ(after.header.stamp, ros::Time(940.0));
  EXPECT_NEAR(after.position[kWheels] - before.position[kWheels], 0.01 / BaseFrames().wheel_radius, 1e-9);
}

/// A bridge to the drives of a simulated base, and a node that commands 0.4 m/s straight ahead at 50 Hz.
class CanBridgeNode : public testing::Test
{
protected:
  void TearDown() override
  {
    std_srvs::Trigger call;
    ros::service::call("/base_simulator/clear_faults", call);
  }

  std_srvs::Trigger::Response call(const std::string& service)
  {
    std_srvs::Trigger trigger;
    EXPECT_TRUE(ros::service::waitForService("/can_bridge/" + service, ros::Duration(kPatience)));
    EXPECT_TRUE(ros::service::call("/can_bridge/" + service, trigger));
    return trigger.response;
  }

  /// The drives need a moment after the bridge's start, and after faults.
  void drive()
  {
    ASSERT_TRUE(wait_until([this] { return call("enable").success; }));
    wheel_states_.clear();
    ASSERT_TRUE(wait_for_states([](const WheelStates& s) { return std::abs(s.drive_speed[0] - 0.4) < 0.02; }));
  }

  bool wait_for_states(const std::function<bool(const WheelStates&)>& condition)
  {
    return wheel_states_.wait_for(condition) != nullptr;
  }
  bool wait_for_state(std::uint8_t state)
  {
    return wait_for_states([state](const WheelStates& s) { return s.state == state; });
  }
  bool wait_for_message(const std::string& message)
  {
    return wait_for_states([&](const WheelStates& s) { return s.message == message; });
  }
  bool wait_for_rest()
  {
    wheel_states_.clear();
    return wait_for_states([](const WheelStates& s) { return std::abs(s.drive_speed[0]) < 0.005; });
  }

  void inject(const std::string& kind, int node, int value)
  {
    InjectFault fault;
    fault.request.kind = kind;
    fault.request.node = static_cast<std::uint8_t>(node);
    fault.request.value = value;
    ASSERT_TRUE(ros::service::call("/base_simulator/inject_fault", fault));
    ASSERT_TRUE(fault.response.success) << fault.response.message;
  }

  void press_emergency_stop(bool pressed)
  {
    ASSERT_TRUE(wait_until([this] { return emergency_stop_.getNumSubscribers() > 0; }));
    std_msgs::Bool message;
    message.data = pressed;
    emergency_stop_.publish(message);
  }

  void command(const ros::WallTimerEvent&)
  {
    WheelCommands message;
    message.header.stamp = ros::Time::now();
    message.mode = 1;
    message.sequence = ++sequence_;
    message.drive_speed.fill(0.4);
    commands_.publish(message);
  }

  ros::NodeHandle node_;
  NodeProcess bridge_{"can_bridge_node", {}};
  Inbox<WheelStates> wheel_states_{"wheel_states"};
  Inbox<DiagnosticArray> diagnostics_{"/diagnostics"};
  ros::Publisher commands_ = node_.advertise<WheelCommands>("wheel_commands", 1);
  ros::Publisher emergency_stop_ = node_.advertise<std_msgs::Bool>("emergency_stop", 1, true);
  std::uint32_t sequence_ = 0;
  ros::WallTimer timer_ = node_.createWallTimer(ros::WallDuration(0.02), &CanBridgeNode::command, this);
};

TEST_F(CanBridgeNode, says_each_cycle_what_the_wheels_do_and_where_that_leads)
{
  Inbox<nav_msgs::Odometry> odometry("odom");
  Inbox<sensor_msgs::JointState> joints("joint_states");
  ASSERT_TRUE(wait_for_state(WheelStates::READY));
  drive();
  const auto state = wheel_states_.messages().back();
  EXPECT_EQ(state->mode, 1);
  EXPECT_TRUE(state->aligned);
  EXPECT_EQ(state->message, "");
  const auto odom =
      odometry.wait_for([&](const nav_msgs::Odometry& o) { return o.header.stamp == state->header.stamp; });
  ASSERT_TRUE(odom) << "no odometry of the same stamp";
  EXPECT_NEAR(odom->twist.twist.linear.x, 0.4, 0.02);
  EXPECT_GT(odom->twist.covariance[0], 0.0);
  EXPECT_TRUE(joints.wait_for([](const sensor_msgs::JointState& j) { return j.position.size() == 8; }));
}

TEST_F(CanBridgeNode, a_silent_drive_ends_the_odometry_but_not_the_state_which_keeps_its_stamp)
{
  Inbox<nav_msgs::Odometry> odometry("odom");
  drive();
  inject("node_silent", 6, 0);
  const auto fault = wheel_states_.wait_for([](const WheelStates& s) { return s.state == WheelStates::FAULT; });
  ASSERT_TRUE(fault);
  wheel_states_.clear();
  odometry.clear();
  ASSERT_TRUE(wait_until([this] { return wheel_states_.messages().size() > 20; }));
  EXPECT_EQ(wheel_states_.messages().back()->header.stamp, fault->header.stamp);
  EXPECT_TRUE(odometry.messages().empty());
}

TEST_F(CanBridgeNode, the_emergency_stop_stops_it_and_forbids_to_enable_it)
{
  drive();
  press_emergency_stop(true);
  ASSERT_TRUE(wait_for_rest());
  ASSERT_TRUE(wait_for_state(WheelStates::READY));
  const auto refusal = call("enable");
  EXPECT_FALSE(refusal.success);
  EXPECT_EQ(refusal.message, "the emergency stop is pressed");
  press_emergency_stop(false);
  drive();
}

TEST_F(CanBridgeNode, a_press_of_the_emergency_stop_that_is_released_at_once_stops_it)
{
  drive();
  press_emergency_stop(true);
  press_emergency_stop(false);
  EXPECT_TRUE(wait_for_message("not enabled: base: emergency_stop"));
}

TEST_F(CanBridgeNode, the_emergency_stop_does_not_wait_for_those_who_wait_for_the_drives)
{
  ASSERT_TRUE(wait_for_state(WheelStates::READY));
  inject("status_frozen", 7, 0);  // it will never say that it is switched on
  std::thread first([this] { call("enable"); }), second([this] { call("enable"); });
  EXPECT_TRUE(wait_for_message("enabling"));
  press_emergency_stop(true);
  first.join();
  second.join();
  wheel_states_.clear();
  EXPECT_TRUE(wait_for_message("not enabled, emergency stop pressed: base: emergency_stop"));
  press_emergency_stop(false);
}

TEST_F(CanBridgeNode, commands_of_impossible_stamps_are_not_taken)
{
  drive();
  WheelCommands wild;
  wild.header.stamp.sec = 0xFFFFFFFF;
  commands_.publish(wild);
  const auto counted = [](const DiagnosticArray& array) {
    for (const DiagnosticStatus& status : array.status)
      for (const auto& value : status.values)
        if (value.key == "late commands" && value.value != "0") return true;
    return false;
  };
  EXPECT_TRUE(diagnostics_.wait_for(counted));
  drive();
}

TEST_F(CanBridgeNode, a_fault_has_its_name_in_the_diagnostics_and_needs_to_be_cleared)
{
  drive();
  inject("drive_fault", 7, 0x2310);
  ASSERT_TRUE(wait_for_state(WheelStates::FAULT));
  const std::string expected = "fault: driving rear_left: emergency_message 0x2310";
  const auto named = [&](const DiagnosticArray& array) {
    for (const DiagnosticStatus& status : array.status)
      if (status.level == DiagnosticStatus::ERROR && status.message == expected) return true;
    return false;
  };
  EXPECT_TRUE(diagnostics_.wait_for(named));
  EXPECT_EQ(call("enable").message, "in fault: clear the faults first (" + expected + ")");
  ASSERT_TRUE(wait_until([this] { return call("clear_faults").success; }));
  drive();
}

TEST_F(CanBridgeNode, asked_to_end_it_comes_to_rest_and_disables_the_drives_first)
{
  drive();
  wheel_states_.clear();
  bridge_.terminate();
  EXPECT_EQ(bridge_.exit_status(), 0);
  const auto states = wheel_states_.messages();
  ASSERT_FALSE(states.empty());
  EXPECT_EQ(states.back()->state, WheelStates::READY) << states.back()->message;
  EXPECT_NEAR(states.back()->drive_speed[0], 0.0, 0.005);
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "can_bridge_rostest");
}
