#include <signal.h>

#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <xmlrpcpp/XmlRpcClient.h>

#include "../support/bus_recorder.h"
#include "fourwis_navigation/Tracking.h"
#include "inbox.h"
#include "ros/conversions.h"
#include "run_rostest.h"

namespace fourwis
{
namespace
{

using fourwis_navigation::Tracking;
using geometry_msgs::PoseStamped;

/// The process of a node, as the node itself says.
pid_t process_of(const std::string& node)
{
  XmlRpc::XmlRpcValue request, response, payload;
  request[0] = ros::this_node::getName();
  request[1] = node;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::master::execute("lookupNode", request, response, payload, true) ||
      !ros::network::splitURI(static_cast<std::string&>(payload), host, port))
    return -1;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port));
  XmlRpc::XmlRpcValue caller, answer;
  caller[0] = ros::this_node::getName();
  return client.execute("getPid", caller, answer) ? static_cast<int&>(answer[2]) : -1;
}

/// Planner, controller, bridge, and the drives of a simulated base, as simulation.launch starts them; the test listens
/// on the bus.
class Bus : public testing::Test
{
protected:
  Pose truth() const
  {
    const auto poses = truth_.messages();
    return poses.empty() ? Pose{} : to_pose(poses.back()->pose, "truth");
  }

  void enable()
  {
    ASSERT_TRUE(wait_until([] {
      std_srvs::Trigger call;
      return ros::service::call("/can_bridge/enable", call) && call.response.success;
    }));
  }

  void send_goal(const Pose& goal)
  {
    ASSERT_TRUE(wait_until([this] { return goal_.getNumSubscribers() > 0; }));
    tracking_.clear();
    PoseStamped message;
    message.header.frame_id = "map";
    message.header.stamp = ros::Time::now();
    message.pose = to_message(goal);
    goal_.publish(message);
  }

  ros::NodeHandle node_;
  ros::Publisher goal_ = node_.advertise<PoseStamped>("move_base_simple/goal", 1);
  Inbox<Tracking> tracking_{"mpc_controller/tracking"};
  Inbox<PoseStamped> truth_{"base_simulator/pose"};
  std::unique_ptr<can::Bus> end_ = can::open_bus(ros::NodeHandle("~").param<std::string>("bus", ""));
  BusRecorder recorder_{*end_};
};

TEST_F(Bus, a_goal_is_reached_over_frames_and_killing_the_bridge_stops_the_drives)
{
  ASSERT_TRUE(truth_.wait_for_any());
  enable();

  const Pose goal{1.1, 5.0, -1.2};  // sideways, then parallel
  send_goal(goal);
  ASSERT_TRUE(tracking_.wait_for([](const Tracking& t) { return t.state == Tracking::ARRIVED; }));
  EXPECT_LT(distance(truth(), goal), 0.02);
  EXPECT_LT(std::abs(wrap_angle(truth().theta - goal.theta)), 0.02);

  send_goal({1.1, 1.1, 0.0});
  ASSERT_TRUE(tracking_.wait_for([](const Tracking& t) { return std::abs(t.speed) > 0.5; }));
  recorder_.poll(0.0);
  recorder_.clear();
  const pid_t bridge = process_of("/can_bridge");
  ASSERT_GT(bridge, 0);
  ASSERT_EQ(kill(bridge, SIGKILL), 0);

  // 0x8130: the master is silent; for how long on the drive's own clock [ms], is in bytes 3 and 4.
  for (std::uint32_t node = 1; node <= 8; ++node)
  {
    std::vector<can::Frame> emergencies;
    ASSERT_TRUE(wait_until([&] { return recorder_.poll(0.0), !(emergencies = recorder_.of(0x080 + node)).empty(); }));
    EXPECT_EQ(emergencies[0].data[0] | emergencies[0].data[1] << 8, 0x8130);
    EXPECT_LE(emergencies[0].data[3] | emergencies[0].data[4] << 8, 100);
  }
  ASSERT_TRUE(wait_until([this] {
    const auto poses = truth_.messages();
    const auto last = poses.end() - 1, before = poses.end() - 20;
    return distance(to_pose((*last)->pose, "now"), to_pose((*before)->pose, "before")) < 1e-6;
  }));
}

}  // namespace
}  // namespace fourwis

int main(int argc, char** argv)
{
  return fourwis::run_rostest(argc, argv, "bus_rostest");
}
