#pragma once

#include <gtest/gtest.h>
#include <ros/ros.h>

#include "../support/grids.h"
#include "fourwis_navigation/ModeTrajectory.h"
#include "fourwis_navigation/WheelStates.h"
#include "fourwis_navigation/planner/planner.h"
#include "ros/conversions.h"
#include "run_rostest.h"
#include "simulated_drive.h"

namespace fourwis
{

using fourwis_navigation::ModeTrajectory;
using fourwis_navigation::WheelStates;

/// In the middle of nothing.
inline const Pose kMiddle{10, 10, 0};

/// Drives the simulated robot along trajectories, without a planner's node. Each test begins at rest in the middle.
class DriveFixture : public testing::Test, protected SimulatedDrive
{
protected:
  void SetUp() override
  {
    wait_for_base();
    repair();
    stop();
    wait_for_rest();
    place(kMiddle);
  }

  /// To be called when there is a controller.
  void connect()
  {
    ASSERT_TRUE(wait_until([this] { return trajectory_.getNumSubscribers() > 0 && tracking_.connected(); }));
    const ros::Time told = stop();
    ASSERT_TRUE(wait_for_state(Tracking::IDLE, told));
    forget();
  }

  /// A trajectory from where the robot is, over free ground.
  Trajectory plan(const Pose& goal, const ModeSet& modes = {}) const
  {
    static const World world(free_area(20.0, 20.0, 0.05), {}, {});
    return Planner(PlannerOptions()).plan(world, {truth(), goal, modes}).trajectory;
  }

  /// Its stamp.
  ros::Time send(const Trajectory& trajectory)
  {
    std_msgs::Header header;
    header.frame_id = "map";
    header.stamp = ros::Time::now();
    trajectory_.publish(to_message(Robot(), trajectory, header));
    return header.stamp;
  }
  ros::Time stop() { return send(Trajectory()); }

  void forget()
  {
    tracking_.clear();
    wheel_states_.clear();
  }

  ros::Publisher trajectory_ = ros::NodeHandle().advertise<ModeTrajectory>("trajectory", 10, true);
  Inbox<WheelStates> wheel_states_{"wheel_states"};
};

}  // namespace fourwis
