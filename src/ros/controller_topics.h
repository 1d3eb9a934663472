#pragma once

#include <functional>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "control_loop.h"
#include "fourwis_navigation/Tracking.h"
#include "fourwis_navigation/model/pose.h"
#include "fourwis_navigation/model/robot.h"
#include "fourwis_navigation/vehicle/base_link.h"

namespace fourwis
{

/// Everything that the controller's node publishes of its steps.
class ControllerTopics
{
public:
  /// Called with the name of a node that no longer listens to `~tracking`: it unsubscribed, or its process has died.
  using ListenerLeft = std::function<void(const std::string&)>;

  ControllerTopics(const Robot& robot, const MpcControllerOptions& options, const ListenerLeft& left);

  /// Command first: nothing else is urgent. `tracking`: the step as `~tracking` has it.
  void publish(const ControlStep& step, const fourwis_navigation::Tracking& tracking,
               const std::vector<Pose>& prediction);

  /// On `~tracking`: the trajectory of this stamp is not driven.
  void publish_refusal(const ros::Time& trajectory, const std::string& message);

  /// On `~tracking`: it is not known yet whether the robot rests.
  void publish_without_measurement(const std::string& message);

private:
  void publish_tracking(std::uint8_t state, const ros::Time& trajectory, const std::string& message);
  void publish_prediction(const ros::Time& stamp, const std::vector<Pose>& prediction);

  const Robot robot_;
  const BaseLink base_link_;
  const std::string global_frame_, robot_base_frame_;
  ros::Time shown_;  ///< when prediction and marker were published last
  ros::Publisher wheel_commands_, cmd_vel_, tracking_, predicted_path_, marker_;
};

/// What `~tracking` says of a step.
fourwis_navigation::Tracking to_message(const ControlStep& step, const std::string& frame);

}  // namespace fourwis
