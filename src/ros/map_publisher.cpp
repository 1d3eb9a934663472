#include "map_publisher.h"

#include <ros/console.h>

#include "conversions.h"

namespace fourwis
{

MapPublisher::MapPublisher(const OccupancyGrid& grid, const std::string& frame)
{
  std_msgs::Header header;
  header.frame_id = frame;
  header.stamp = ros::Time::now();
  publisher_ = node_.advertise<nav_msgs::OccupancyGrid>("map", 1, true);
  map_ = to_message(grid, header);
  publisher_.publish(map_);
  metadata_ = node_.advertise<nav_msgs::MapMetaData>("map_metadata", 1, true);
  metadata_.publish(map_.info);
  static_map_ = node_.advertiseService("static_map", &MapPublisher::serve, this);
  ROS_INFO("map of %d x %d cells at %g m in frame '%s'", grid.width, grid.height, grid.resolution, frame.c_str());
}

bool MapPublisher::serve(nav_msgs::GetMap::Request&, nav_msgs::GetMap::Response& response)
{
  response.map = map_;
  return true;
}

}  // namespace fourwis
