#pragma once

#include <string>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "fourwis_navigation/model/occupancy_grid.h"

namespace fourwis
{

/// Publishes one map, latched, on topic `map`.
class MapPublisher
{
public:
  MapPublisher(const OccupancyGrid& grid, const std::string& frame);

private:
  ros::NodeHandle node_;
  ros::Publisher publisher_;
};

}  // namespace fourwis
