#include "map_publisher.h"

#include <ros/console.h>

#include "conversions.h"

namespace fourwis
{
namespace
{

constexpr double kMaxHeight = 1000.0;

std::string frame_id(KeyReader& reader)
{
  const std::string frame = reader.text("frame_id", "map");
  if (frame.empty()) throw ConfigError("parameter 'frame_id' is empty, expected the name of a frame");
  return frame;
}

}  // namespace

MapPublisher::MapPublisher(const OccupancyGrid& grid, const std::string& frame)
{
  std_msgs::Header header;
  header.frame_id = frame;
  header.stamp = ros::Time::now();
  publisher_ = node_.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
  publisher_.publish(to_message(grid, header));
  ROS_INFO("map of %d x %d cells at %g m in frame '%s'", grid.width, grid.height, grid.resolution, frame.c_str());
}

MapPublisherOptions map_publisher_options_from(const ParameterMap& parameters, const std::string& argument)
{
  KeyReader reader(parameters);
  MapPublisherOptions options;
  options.map_file = argument.empty() ? reader.text("map_file") : reader.text("map_file", argument);
  options.frame_id = frame_id(reader);
  reader.finish();
  return options;
}

OctomapProjectorOptions octomap_projector_options_from(const ParameterMap& parameters)
{
  KeyReader reader(parameters);
  OctomapProjectorOptions options;
  options.octomap_file = reader.text("octomap_file");
  options.band.min = reader.number("min_height", -kMaxHeight, kMaxHeight, "m", options.band.min);
  options.band.max = reader.number("max_height", options.band.min, kMaxHeight, "m", options.band.max);
  options.frame_id = frame_id(reader);
  reader.finish();
  return options;
}

}  // namespace fourwis
