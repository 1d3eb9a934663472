#include "../global_planner.h"
#include "../node_main.h"
#include "../parameter_server.h"
#include "fourwis_navigation/vehicle/mode_limits.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "global_planner");
  return fourwis::node_main([] {
    const auto parameters = fourwis::global_planner_parameters_from(fourwis::read_parameters(ros::NodeHandle("~")));
    fourwis::warn(parameters.defaults);
    fourwis::warn(fourwis::limitations(parameters.robot));
    const fourwis::GlobalPlanner planner(parameters);
    ros::spin();
  });
}
