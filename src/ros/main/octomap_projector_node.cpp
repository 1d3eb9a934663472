#include "../map_publisher.h"
#include "../node_main.h"
#include "../parameter_server.h"
#include "fourwis_navigation/map/octomap_projection.h"
#include "fourwis_navigation/parameters/node_parameters.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "octomap_projector");
  return fourwis::node_main([] {
    const auto options = fourwis::octomap_projector_options_from(fourwis::read_parameters(ros::NodeHandle("~")));
    const fourwis::MapPublisher publisher(fourwis::project_octomap_file(options.octomap_file, options.band),
                                          options.frame_id);
    ros::spin();
  });
}
