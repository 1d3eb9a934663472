#pragma once

#include <map>
#include <string>

#include <actionlib/client/simple_action_client.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <gtest/gtest.h>
#include <map_msgs/OccupancyGridUpdate.h>
#include <move_base_msgs/MoveBaseAction.h>
#include <nav_msgs/GetPlan.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>

#include "../support/grids.h"
#include "fourwis_navigation/ModeTrajectory.h"
#include "fourwis_navigation/PlanTrajectory.h"
#include "fourwis_navigation/PlannerStatus.h"
#include "inbox.h"
#include "ros/conversions.h"
#include "run_rostest.h"

namespace fourwis
{

using fourwis_navigation::ModeTrajectory;
using fourwis_navigation::PlannerStatus;
using fourwis_navigation::PlanTrajectory;
using MoveBaseClient = actionlib::SimpleActionClient<move_base_msgs::MoveBaseAction>;

/// A free square map with its lower left corner at the origin and a wall of one cell around it.
inline nav_msgs::OccupancyGrid walled_map(double side, double resolution, double stamp)
{
  OccupancyGrid grid = free_area(side, side, resolution);
  wall_in(grid, 1, 1, grid.width - 2, grid.height - 2);
  std_msgs::Header header;
  header.frame_id = "map";
  header.stamp = ros::Time(stamp);
  return to_message(grid, header);
}

/// Occupies the cells of a rectangle given in metres; for maps at the origin.
inline void occupy(double x, double y, double width, double height, nav_msgs::OccupancyGrid& map)
{
  const double resolution = map.info.resolution;
  const auto cells = [resolution](double length) { return static_cast<int>(std::lround(length / resolution)); };
  for (int row = cells(y); row < cells(y + height); ++row)
    for (int column = cells(x); column < cells(x + width); ++column)
      map.data[static_cast<std::size_t>(row) * map.info.width + static_cast<std::size_t>(column)] = 100;
}

inline geometry_msgs::PoseStamped stamped(const Pose& pose, const std::string& frame = "map")
{
  geometry_msgs::PoseStamped message;
  message.header.frame_id = frame;
  message.pose = to_message(pose);
  return message;
}

/// Speaks to a planner called move_base and keeps what it says.
class PlannerFixture : public testing::Test
{
protected:
  PlannerFixture()
  {
    goal_ = node_.advertise<geometry_msgs::PoseStamped>("move_base_simple/goal", 10);
    map_ = node_.advertise<nav_msgs::OccupancyGrid>("map", 10);
    update_ = node_.advertise<map_msgs::OccupancyGridUpdate>("map_updates", 100);
    initial_pose_ = node_.advertise<geometry_msgs::PoseWithCovarianceStamped>("initialpose", 10);
  }

  void SetUp() override
  {
    ASSERT_TRUE(wait_until([this] {
      return action_.isServerConnected() && ros::service::exists("/move_base/cancel", false) &&
             ros::service::exists("/move_base/plan_trajectory", false) && goal_.getNumSubscribers() > 0 &&
             map_.getNumSubscribers() > 0 && update_.getNumSubscribers() > 0 && trajectories_.connected() &&
             statuses_.connected();
    }));
    // Latched: what the planner said last, perhaps in another test.
    ASSERT_TRUE(statuses_.wait_for_any());
  }

  /// Returns once plans are made on it; its stamp must be new.
  void set_map(const nav_msgs::OccupancyGrid& map)
  {
    map_.publish(map);
    wait_for_map(map.header.stamp);
  }
  void wait_for_map(const ros::Time& stamp)
  {
    ASSERT_TRUE(wait_until([&] { return plan(stamped({}), stamped({})).map_stamp == stamp; }));
  }

  /// Returns once plans start there; there must be a map, and it must be free.
  void set_start(const Pose& pose)
  {
    ASSERT_TRUE(wait_until([this] { return initial_pose_.getNumSubscribers() > 0; }));
    geometry_msgs::PoseWithCovarianceStamped message;
    message.header.frame_id = "map";
    message.pose.pose = to_message(pose);
    initial_pose_.publish(message);
    ASSERT_TRUE(wait_until([&] { return starts_at(pose); }));
  }

  /// Whether the planner knows that the robot is there.
  bool starts_at(const Pose& pose)
  {
    const auto points = plan(stamped({}, ""), stamped(pose)).trajectory.points;
    return !points.empty() && std::abs(points.front().x - pose.x) < 1e-3 && std::abs(points.front().y - pose.y) < 1e-3;
  }

  void send_goal(const geometry_msgs::PoseStamped& goal) { goal_.publish(goal); }
  void send_goal(const Pose& goal) { send_goal(stamped(goal)); }

  PlanTrajectory::Response plan(const geometry_msgs::PoseStamped& start, const geometry_msgs::PoseStamped& goal,
                                const std::vector<std::string>& modes = {})
  {
    PlanTrajectory call;
    call.request.start = start;
    call.request.goal = goal;
    call.request.modes = modes;
    EXPECT_TRUE(ros::service::call("/move_base/plan_trajectory", call));
    return call.response;
  }

  std_srvs::Trigger::Response cancel()
  {
    std_srvs::Trigger call;
    EXPECT_TRUE(ros::service::call("/move_base/cancel", call));
    return call.response;
  }

  /// The first status of this name about this goal since the inbox was cleared.
  Inbox<PlannerStatus>::Pointer wait_for_status(const std::string& name, const Pose& goal)
  {
    return statuses_.wait_for([&](const PlannerStatus& status) {
      return status.status == name && status.goal.pose.position.x == goal.x && status.goal.pose.position.y == goal.y;
    });
  }

  /// The first trajectory for a goal given at `time` or later: it begins `start_delay` after that. It comes on a
  /// connection of its own: the status that tells of it may be here before.
  Inbox<ModeTrajectory>::Pointer wait_for_trajectory_since(const ros::Time& time)
  {
    double start_delay = 0.0;
    EXPECT_TRUE(node_.getParam("move_base/start_delay", start_delay));
    const ros::Time begin = time + ros::Duration(start_delay);
    return trajectories_.wait_for([&](const ModeTrajectory& t) { return t.header.stamp >= begin; });
  }

  /// The trajectory that is published now, as a late subscriber sees it.
  static Inbox<ModeTrajectory>::Pointer latched_trajectory()
  {
    return Inbox<ModeTrajectory>("trajectory").wait_for_any();
  }

  ros::NodeHandle node_;
  ros::Publisher goal_, map_, update_, initial_pose_;
  Inbox<PlannerStatus> statuses_{"move_base/planner_status"};
  Inbox<ModeTrajectory> trajectories_{"trajectory"};
  MoveBaseClient action_{"move_base", false};
};

}  // namespace fourwis
