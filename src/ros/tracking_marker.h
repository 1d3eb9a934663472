#pragma once

#include <cstdint>
#include <string>

#include <visualization_msgs/Marker.h>

#include "fourwis_navigation/Tracking.h"

namespace fourwis
{

/// A state of Tracking in words.
const char* name_of(std::uint8_t state);

/// What the controller is doing and how far off it is, as text beside the robot, which it follows.
visualization_msgs::Marker tracking_marker(const fourwis_navigation::Tracking& tracking,
                                           const std::string& robot_base_frame);

}  // namespace fourwis
