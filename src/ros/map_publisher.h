#pragma once

#include <string>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "fourwis_navigation/map/octomap_projection.h"
#include "fourwis_navigation/model/occupancy_grid.h"
#include "node_parameters.h"

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

/// What map_publisher_node is configured with: `~map_file` (or the first argument) and `~frame_id`, "map" by default.
struct MapPublisherOptions
{
  std::string map_file;  ///< map_server's YAML
  std::string frame_id;
};

/// `argument` stands in for a missing `map_file`; empty when there is none. Throws ConfigError.
MapPublisherOptions map_publisher_options_from(const ParameterMap& parameters, const std::string& argument);

/// What octomap_projector_node is configured with: `~octomap_file`, `~min_height`, `~max_height` and `~frame_id`.
struct OctomapProjectorOptions
{
  std::string octomap_file;  ///< .bt or .ot
  HeightBand band;
  std::string frame_id;
};

/// Throws ConfigError.
OctomapProjectorOptions octomap_projector_options_from(const ParameterMap& parameters);

}  // namespace fourwis
