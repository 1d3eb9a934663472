#include "fourwis_navigation/ros/global_planner.h"
#include "fourwis_navigation/ros/node_main.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "global_planner");
  return fourwis::node_main([] {
    const fourwis::GlobalPlanner planner(
        fourwis::global_planner_parameters_from(fourwis::read_parameters(ros::NodeHandle("~"))));
    ros::spin();
  });
}
