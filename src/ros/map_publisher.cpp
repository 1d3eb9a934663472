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
  publisher_.publish(to_message(grid, header));
  ROS_INFO("map of %d x %d cells at %g m in frame '%s'", grid.width, grid.height, grid.resolution, frame.c_str());
}

}  // namespace fourwis
