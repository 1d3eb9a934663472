#include "tracking_marker.h"

#include <cmath>
#include <sstream>

namespace fourwis
{

using fourwis_navigation::Tracking;
using visualization_msgs::Marker;

const char* name_of(std::uint8_t state)
{
  switch (state)
  {
    case Tracking::IDLE: return "no trajectory";
    case Tracking::ALIGNING: return "turning the wheels";
    case Tracking::DRIVING: return "driving";
    case Tracking::STOPPING: return "stopping";
    case Tracking::ARRIVED: return "arrived";
    default: return "gave up";
  }
}

Marker tracking_marker(const Tracking& tracking, const std::string& robot_base_frame)
{
  std::ostringstream text;
  text << name_of(tracking.state);
  if (tracking.state == Tracking::DRIVING)
    text << "\nlateral " << std::lround(tracking.lateral_error * 1e3) << " mm\nlongitudinal "
         << std::lround(tracking.longitudinal_error * 1e3) << " mm";
  if (!tracking.message.empty()) text << '\n' << tracking.message;

  Marker marker;
  marker.header.frame_id = robot_base_frame;
  marker.frame_locked = 1;
  marker.ns = "tracking";
  marker.type = Marker::TEXT_VIEW_FACING;
  marker.action = Marker::ADD;
  marker.pose.position.y = -0.8;
  marker.pose.position.z = 1.0;
  marker.pose.orientation.w = 1.0;
  marker.scale.z = 0.2;
  const bool has_message = !tracking.message.empty();
  marker.color.r = has_message ? 0.85f : 0.1f;
  marker.color.g = marker.color.b = 0.1f;
  marker.color.a = 1.0f;
  marker.text = text.str();
  return marker;
}

}  // namespace fourwis
