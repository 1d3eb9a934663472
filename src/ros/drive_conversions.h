#pragma once

#include <std_msgs/Header.h>

#include "conversions.h"
#include "fourwis_navigation/ModeTrajectory.h"
#include "fourwis_navigation/WheelCommands.h"
#include "fourwis_navigation/WheelStates.h"
#include "fourwis_navigation/model/trajectory.h"
#include "fourwis_navigation/model/wheels.h"

namespace fourwis
{

// The numbers are taken as they are, also modes that are none of ours: the receiver judges them.
Trajectory to_trajectory(const fourwis_navigation::ModeTrajectory& message);
WheelCommand to_command(const fourwis_navigation::WheelCommands& message);
/// A state that is none of the message's constants is taken for a fault.
WheelState to_wheel_state(const fourwis_navigation::WheelStates& message);

fourwis_navigation::WheelCommands to_message(const WheelCommand& command, const ros::Time& stamp);

/// `explanation` is what is the matter with the base; empty when it is enabled.
fourwis_navigation::WheelStates to_message(const WheelState& state, const ros::Time& stamp,
                                           const std::string& explanation);

}  // namespace fourwis
