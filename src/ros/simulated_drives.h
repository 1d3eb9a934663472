#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <ros/wall_timer.h>
#include <tf2/buffer_core.h>

#include "fault_services.h"
#include "fourwis_navigation/drives/bus_base.h"
#include "fourwis_navigation/vehicle/base_link.h"
#include "ideal_localization.h"

namespace fourwis
{

/// The simulator's node with a bus: eight drives on it, turning the wheels of a base, and a localisation that knows where that
/// really is. Wheel states and odometry are the bridge's to publish, as on the robot. In real time, as its bridge is.
/// Spin it with one thread.
class SimulatedDrives
{
public:
  /// Throws ConfigError where there is a simulated time, and std::invalid_argument for a bus that can be none.
  explicit SimulatedDrives(const BaseSimulatorParameters& parameters);

private:
  void place(const Pose& pose);  ///< of base_link
  void step();
  void publish();
  void on_odometry(const nav_msgs::Odometry& odometry);
  Pose truth_at(const ros::Time& stamp);
  void inject(const fourwis_navigation::InjectFault::Request& request);

  const BaseFrames frames_;
  const BaseLink base_link_;
  drives::BusBase base_;
  tf2::BufferCore truth_;  ///< where the robot was lately
  IdealLocalization localization_;
  FaultServices faults_;
  ros::NodeHandle node_;
  ros::Subscriber odometry_;
  ros::WallTimer step_timer_, publication_;
};

}  // namespace fourwis
