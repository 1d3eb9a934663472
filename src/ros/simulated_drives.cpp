#include "simulated_drives.h"

#include "conversions.h"
#include "fourwis_navigation/model/sentence.h"

#include <ros/console.h>
#include <tf2/exceptions.h>

namespace fourwis
{
namespace
{

/// How often the bus is looked at: one step of the drives.
const ros::WallDuration kStep(0.001);

/// Names within the record of where the robot was.
const std::string kWorld = "world", kRobot = "robot";

/// The parameters themselves, for the list of initialisers. Throws ConfigError in simulated time.
const BaseSimulatorParameters& in_real_time(const BaseSimulatorParameters& parameters)
{
  if (ros::Time::isSimTime())
    throw ConfigError("parameter '/use_sim_time' is true, expected false where 'bus' is '" + parameters.node.bus +
                      "': its drives run in real time");
  return parameters;
}

}  // namespace

SimulatedDrives::SimulatedDrives(const BaseSimulatorParameters& parameters)
  : frames_(in_real_time(parameters).node.frames),
    base_link_(parameters.robot),
    base_(parameters.node.bus, parameters.robot, parameters.bridge, parameters.simulator),
    localization_(parameters.node, [this](const Pose& pose) { place(pose); }),
    faults_([this](const auto& fault) { inject(fault); }, [this] { base_.drives().clear_faults(); })
{
  place(parameters.node.initial);
  odometry_ = node_.subscribe<nav_msgs::Odometry>(
      "odom", 10, [this](const nav_msgs::OdometryConstPtr& message) { on_odometry(*message); }, nullptr,
      ros::TransportHints().tcpNoDelay());
  step_timer_ = node_.createWallTimer(kStep, [this](const ros::WallTimerEvent&) { step(); });
  publication_ = node_.createWallTimer(ros::WallDuration(1.0 / parameters.node.publish_frequency),
                                       [this](const ros::WallTimerEvent&) { publish(); });
}

void SimulatedDrives::place(const Pose& pose)
{
  base_.drives().place(base_link_.to_centre(pose));
}

void SimulatedDrives::step()
{
  base_.advance(ros::SteadyTime::now().toSec());
}

void SimulatedDrives::publish()
{
  const ros::Time now = ros::Time::now();
  const Pose pose = base_link_.from_centre(base_.drives().pose());
  std_msgs::Header header;
  header.stamp = now;
  header.frame_id = kWorld;
  truth_.setTransform(to_message(pose, header, kRobot), "simulator");
  localization_.publish(now, pose);
}

void SimulatedDrives::on_odometry(const nav_msgs::Odometry& odometry)
{
  try
  {
    if (odometry.header.frame_id != frames_.odom_frame)
      reject<ConversionError>("odom: header.frame_id is '", odometry.header.frame_id, "', expected odom_frame = '",
                              frames_.odom_frame, "'");
    publish();  // so that there is a truth as new as the odometry
    const Pose truth = truth_at(odometry.header.stamp);
    localization_.correct(odometry.header.stamp, truth, to_pose(odometry.pose.pose, "odom"));
  }
  catch (const ConversionError& error)
  {
    ROS_WARN_THROTTLE(1.0, "%s", error.what());
  }
}

Pose SimulatedDrives::truth_at(const ros::Time& stamp)
{
  try
  {
    return to_pose(truth_.lookupTransform(kWorld, kRobot, stamp).transform, "truth");
  }
  catch (const tf2::TransformException& error)
  {
    reject<ConversionError>("odom: it is not known where the robot was at ", stamp, ": ", error.what());
  }
}

void SimulatedDrives::inject(const fourwis_navigation::InjectFault::Request& request)
{
  const auto kind = drives::drive_fault_kind(request.kind);
  if (!kind)
    reject<ConversionError>("inject_fault: kind is '", request.kind, "', expected a word of doc/fake_drives.md");
  drives::DriveFault fault;
  fault.kind = *kind;
  fault.node = request.node;
  fault.begin = base_.drives().time();
  fault.value = request.value;
  try
  {
    base_.drives().inject(fault);
  }
  catch (const std::out_of_range& error)
  {
    reject<ConversionError>("inject_fault: ", error.what());
  }
}

}  // namespace fourwis
