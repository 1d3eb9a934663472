#include "../map_publisher.h"
#include "../node_main.h"
#include "../parameter_server.h"
#include "fourwis_navigation/map/map_file.h"
#include "fourwis_navigation/parameters/node_parameters.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "map_publisher");
  return fourwis::node_main([&] {
    const auto options =
        fourwis::map_publisher_options_from(fourwis::read_parameters(ros::NodeHandle("~")), argc > 1 ? argv[1] : "");
    std::string warning;
    const fourwis::OccupancyGrid grid = fourwis::read_map_file(options.map_file, &warning);
    if (!warning.empty()) fourwis::warn({warning});
    const fourwis::MapPublisher publisher(grid, options.frame_id);
    ros::spin();
  });
}
