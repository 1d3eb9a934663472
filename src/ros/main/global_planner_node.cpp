#include "../global_planner.h"
#include "../node_main.h"
#include "../parameter_server.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "global_planner");
  return fourwis::node_main([] {
    const fourwis::GlobalPlanner planner(
        fourwis::global_planner_parameters_from(fourwis::read_parameters(ros::NodeHandle("~"))));
    ros::spin();
  });
}
