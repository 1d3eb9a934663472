#pragma once

#include <string>

#include <nav_msgs/GetMap.h>
#include <nav_msgs/OccupancyGrid.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>

#include "fourwis_navigation/model/occupancy_grid.h"

namespace fourwis
{

/// Offers one map as map_server does: latched on the topics `map` and `map_metadata`, and by the service `static_map`.
class MapPublisher
{
public:
  MapPublisher(const OccupancyGrid& grid, const std::string& frame);

private:
  bool serve(nav_msgs::GetMap::Request& request, nav_msgs::GetMap::Response& response);

  ros::NodeHandle node_;
  nav_msgs::OccupancyGrid map_;
  ros::Publisher publisher_, metadata_;
  ros::ServiceServer static_map_;
};

}  // namespace fourwis
