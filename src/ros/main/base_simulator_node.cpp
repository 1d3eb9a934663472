#include "fourwis_navigation/ros/node_main.h"
#include "fourwis_navigation/ros/simulated_robot.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "base_simulator");
  return fourwis::node_main(
    []
    {
      const fourwis::SimulatedRobot robot(
        fourwis::base_simulator_parameters_from(fourwis::read_parameters(ros::NodeHandle("~"))));
      ros::spin();
    });
}
